#include "model/sha256.h"

#include <vector>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

TEST(sha256, gives_the_digests_of_the_standards_examples) {
  EXPECT_EQ(sha256(std::string()), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256(std::string("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(std::string("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(sha256, of_many_pieces_is_that_of_the_whole) {
  // Longer than a piece; computed with coreutils: head -c 10000000 /dev/zero | sha256sum
  const std::vector<std::uint8_t> zeros(10'000'000);
  EXPECT_EQ(sha256(zeros), "f5e02aa71e67f41d79023a128ca35bad86cf7b6656967bfe0884b3a3c4325eaf");
}

TEST(sha256, gives_up_when_asked_to) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(sha256(std::vector<std::uint8_t>(10), stop.get_token()), "");
}

}  // namespace
}  // namespace gabarit
