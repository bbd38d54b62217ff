// SPDX-License-Identifier: AGPL-3.0-or-later
// Lists the sections that have all words of the search, those first that have them in the heading.
"use strict";
{
  const most = 20;
  const field = document.getElementById("search"), found = document.getElementById("found");
  const up = document.body.dataset.up;
  const count = (words, text) => words.filter(word => text.includes(word)).length;

  function entry(section, words) {
    const item = document.createElement("li"), link = document.createElement("a");
    const around = document.createElement("small");
    link.href = up + section.page;
    link.textContent = section.heading;
    const at = Math.max(0, section.text.toLowerCase().indexOf(words[0]) - 40);
    around.textContent = section.title + ": " + section.text.slice(at, at + 110);
    item.append(link, around);
    return item;
  }

  function search() {
    const words = field.value.toLowerCase().split(/\s+/).filter(word => word);
    const hits = [];
    if (words.length > 0)
      for (const section of manual) {
        const heading = section.heading.toLowerCase(), text = heading + " " + section.text.toLowerCase();
        if (count(words, text) === words.length)
          hits.push({ section, rank: count(words, heading) });
      }
    hits.sort((a, b) => b.rank - a.rank);
    found.replaceChildren(...hits.slice(0, most).map(hit => entry(hit.section, words)));
  }
  field.addEventListener("input", search);
}
