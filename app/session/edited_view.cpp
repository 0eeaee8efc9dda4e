// SPDX-License-Identifier: MIT
#include "app/session/edited_view.h"

namespace flipbook::app {

EditedView::EditedView(const Resolved& resolved) : resolved_(&resolved), request_(resolved.request()) {}

void EditedView::set(const SetParameter& change, double time) {
  // A range belongs to the quantity that it was written for.
  std::erase_if(changes_, [&](const Assignment& a) {
    return a.path == change.path || (change.path == "view.colour" && a.path == "view.range");
  });
  changes_.push_back({change.path, change.value, {}});
  merge(request_, at(time).request());
}

render::ViewSettings EditedView::at(double time) const {
  render::ViewSettings view = resolved_->timeline.view(time, resolved_->view);
  Mistakes checked_before;
  change_view(view, changes_, checked_before);
  return view;
}

} // namespace flipbook::app
