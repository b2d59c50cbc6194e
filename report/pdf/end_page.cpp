#include "report/pdf/end_page.h"

#include <array>

#include <fmt/format.h>

namespace gabarit::pdf {

static void draw_signature(Flow& flow, const char* role) {
  constexpr std::array fields{"Name", "Date", "Signature"};
  constexpr std::array widths{60.0, 35.0, 65.0};
  flow.subheading(role);
  flow.skip(9);
  double x = margin_left;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    flow.canvas().line({x, flow.y()}, {x + widths[i], flow.y()}, ink, 0.25);
    flow.canvas().text({x, flow.y() + 4}, fields[i], label_text);
    x += widths[i] + 5;
  }
  flow.skip(9);
}

void add_end_page(Book& book) {
  Flow& flow = book.flow;
  flow.begin_page("End of report");
  flow.document().add_bookmark("End of report");
  flow.heading("End of report");
  flow.paragraph(fmt::format(
      "This is the last page of report {}. It relates only to the files listed on its cover, identified by "
      "their "
      "SHA-256. It is a geometric check, not a type approval: it says nothing about materials, strength, or "
      "requirements that are not among the rules listed.",
      book.report->id));
  flow.paragraph(
      "The report may be passed on as a whole only. The verdicts follow from the decision rule stated with "
      "each rule; the "
      "bounds are numerical (tessellation, sampling, arithmetic) and not a coverage probability.");
  flow.skip(grid_step);
  for (const char* const role : {"Prepared by", "Reviewed by", "Authorised by"}) draw_signature(flow, role);
}

}  // namespace gabarit::pdf
