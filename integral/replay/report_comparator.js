// SPDX-License-Identifier: AGPL-3.0-or-later
// Opens the comparison of a pair within the report of a suite: fills the pair's pieces into the
// page's text, which all pairs share, and shows the page in a frame.
"use strict";
(() => {
const data = (id) => JSON.parse(document.getElementById(id).textContent);
const dialog = document.getElementById("comparator"), frame = dialog.querySelector("iframe");

function page_of(pieces) {
  const marks = new RegExp("@(" + Object.keys(pieces).join("|") + ")@");
  return data("comparison-shell").split(marks).map((text, k) => k % 2 ? pieces[text] : text).join("");
}

frame.addEventListener("load", () => {
  frame.contentWindow.focus();
  frame.contentWindow.addEventListener("keydown", (event) => {
    if (event.key === "Escape")
      dialog.close();
  });
});
dialog.querySelector("button").addEventListener("click", () => dialog.close());
dialog.addEventListener("close", () => { frame.srcdoc = ""; });
for (const button of document.querySelectorAll("[data-comparison]")) {
  button.hidden = false;
  button.addEventListener("click", () => {
    frame.srcdoc = page_of(data(button.dataset.comparison));
    dialog.showModal();
  });
}
})();
