// SPDX-License-Identifier: AGPL-3.0-or-later
// Shows two frames on the replay page: divided by a line, side by side, as their difference, one
// alone, or both in turn.

const shown_words = {
  line: "Left of the line is the reference, right of it the result.",
  beside: "The reference is on the left or above, the result on the right or below.",
  difference: "The difference of the two views, of each colour: black is equal.",
  reference: "The reference.",
  result: "The result.",
  blink: "Both are shown in turn at one place: what differs flickers, what is equal stands still.",
};

class Comparison {
  shown = "line";
  at = 0.5;      // the line's place, as a part of the view's width
  timer = 0;     // of blinking
  shows_result = false; // whether blinking shows the result at the moment

  // `redraw` draws the page anew; `visit` moves the eye to a difference ({ eye, place }) and marks it.
  constructor(start, redraw, visit) {
    this.redraw = redraw;
    this.gain = element("gain");
    this.line = element("split");
    this.line.addEventListener("input", () => { this.at = Number(this.line.value); this.show("line"); });
    this.gain.addEventListener("input", () => this.show("difference"));
    this.buttons = [...element("comparison").querySelectorAll("[data-show]")];
    for (const button of this.buttons)
      button.addEventListener("click", () => this.choose(button.dataset.show));
    const keys = { l: "line", s: "beside", d: "difference", 1: "reference", 2: "result", b: "blink" };
    const worst = element("worst"), go = () => visit(start.worst);
    if (start.worst) {
      worst.hidden = false;
      worst.title = start.worst.words;
      worst.addEventListener("click", go);
    }
    this.notes = [start.note, start.worst?.words].filter(Boolean).map((words) => " " + words).join("");
    document.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey)
        return;
      if (keys[event.key])
        this.choose(keys[event.key]);
      else if (event.key === "w" && start.worst)
        go();
    });
  }

  // Starts with `show` and the line's place, both from the address's fragment.
  begin(show, at) {
    this.at = at;
    this.show(shown_words[show] ? show : "line");
  }

  // Handles a button or key; choosing "blink" again ends blinking.
  choose(show) {
    this.show(show === "blink" && this.shown === "blink" ? "line" : show);
  }

  show(show) {
    clearInterval(this.timer);
    this.shown = show;
    this.shows_result = false;
    if (show === "blink")
      this.timer = setInterval(() => { this.shows_result = !this.shows_result; this.redraw(); }, 500);
    for (const button of this.buttons)
      button.setAttribute("aria-pressed", String(button.dataset.show === show));
    element("split-slider").hidden = show !== "line";
    element("gain-slider").hidden = show !== "difference";
    this.line.value = this.at;
    const state = (slider, text) => {
      slider.setAttribute("aria-valuetext", text);
      slider.parentElement.querySelector("output").textContent = text;
    };
    state(this.line, this.at <= 0 ? "the result" : this.at >= 1 ? "the reference" : "both");
    state(this.gain, String(2 ** this.gain.value));
    element("comparison-words").textContent = shown_words[show] + this.notes;
    this.redraw();
  }

  // Draws the two views on the canvas.
  draw(drawing, views, canvas) {
    const [width, height] = drawing.size, whole = (index) => drawing.draw(index, views[index]);
    if (this.shown === "line") {
      const edge = Math.round(this.at * width);
      drawing.draw(0, views[0], 0, edge);
      drawing.draw(1, views[1], edge, width);
    } else if (this.shown === "beside") {
      drawing.clear(canvas.width, canvas.height);
      drawing.draw(0, views[0], 0, width, [0, canvas.height - height]);
      drawing.draw(1, views[1], 0, width, [canvas.width - width, 0]);
    } else if (this.shown === "difference") {
      drawing.draw_difference(...views, 2 ** this.gain.value);
    } else {
      whole(this.shown === "result" || this.shows_result ? 1 : 0);
    }
  }
}
