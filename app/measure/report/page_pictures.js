"use strict";
// The slider: two pictures of one instant, one over the other.
(() => {
  const { element } = unghost;

  function slider_of(instant) {
    const pictures = new Map(), maps = new Map();
    for (const img of instant.querySelectorAll("[data-picture]")) pictures.set(img.dataset.picture, img);
    for (const img of instant.querySelectorAll("[data-map]")) maps.set(img.dataset.map, img);
    const names = [...pictures.keys()];
    if (names.length < 2) return;

    const choice = (name) => {
      const select = element("select", {}, ...names.map((each) => element("option", { value: each, textContent: each })));
      select.value = name;
      return select;
    };
    const modes = names.filter((name) => name !== "reference");
    const left = choice(modes[0]), right = choice(modes[modes.length - 1]);
    const flip = element("input", { type: "checkbox" });
    const under = element("img", { alt: "" }), over = element("img", { alt: "", className: "over" });
    const edge = element("div", { className: "edge" });
    const left_tag = element("div", { className: "tag l" }), right_tag = element("div", { className: "tag r" });
    const range = element("input", { type: "range", min: 0, max: 100, step: 0.5, value: 50 });
    range.setAttribute("aria-label", "Where the left picture ends");
    const stage = element("div", { className: "stage" }, under, over, edge, left_tag, right_tag);

    function picture(name) { return flip.checked && maps.has(name) ? maps.get(name) : pictures.get(name); }
    function choose() {
      over.src = picture(left.value).src, under.src = picture(right.value).src;
      const first = pictures.get(left.value);
      under.width = first.width, under.height = first.height;
      const map = (name) => name + (flip.checked && maps.has(name) ? ", FLIP map" : "");
      over.alt = left_tag.textContent = map(left.value);
      under.alt = right_tag.textContent = map(right.value);
    }
    function move() {
      over.style.clipPath = `inset(0 ${100 - range.value}% 0 0)`;
      edge.style.left = range.value + "%";
      range.setAttribute("aria-valuetext", `${left.value} on the left ${Math.round(range.value)} percent`);
    }
    function drag(event) {
      const box = stage.getBoundingClientRect();
      range.value = 100 * (event.clientX - box.left) / box.width;
      move();
    }
    stage.addEventListener("pointerdown", (event) => {
      stage.setPointerCapture(event.pointerId);
      drag(event);
    });
    stage.addEventListener("pointermove", (event) => { if (event.buttons > 0) drag(event); });
    range.addEventListener("input", move);
    for (const control of [left, right, flip]) control.addEventListener("change", () => { choose(), move(); });
    choose(), move();

    instant.querySelector(".note").after(element("div", { className: "slider" },
      element("div", { className: "controls" },
        element("label", {}, "Left ", left),
        element("label", {}, flip, " FLIP maps"),
        element("label", { className: "right" }, "Right ", right)),
      stage, range));
  }
  for (const instant of document.querySelectorAll(".instant")) slider_of(instant);
})();
