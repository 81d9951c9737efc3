"use strict";
// What the page can do beyond being read: one case at a time, a filter of modes, tables that sort.
const unghost = {
  data: JSON.parse(document.getElementById("data").textContent),
  hidden: new Set(),
  watchers: [], // called when modes are hidden or shown, or another case is
  changed() { for (const watcher of unghost.watchers) watcher(); },
  element(name, properties = {}, ...children) {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
  },
};

(() => {
  const { element } = unghost;

  // Cases: without this script, one after the other.
  const links = [...document.querySelectorAll(".cases a")];
  const cases = [...document.querySelectorAll("section.case")];
  function show_case(id) {
    for (const section of cases) section.classList.toggle("off", section.id !== id);
    for (const link of links)
      if (link.hash === "#" + id) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    unghost.changed();
  }
  if (links.length > 0) {
    // The case that has the place of that name: it may be any in it, a chart or a table
    const case_of = (id) => cases.find((section) => section.id === id || (id && section.contains(document.getElementById(id))));
    for (const link of links)
      link.addEventListener("click", (event) => {
        event.preventDefault(); // stays where the reader is: the charts change beneath
        history.replaceState(null, "", link.hash);
        show_case(link.hash.slice(1));
      });
    const follow = () => {
      const id = location.hash.slice(1), section = case_of(id);
      if (!section) return false;
      show_case(section.id);
      document.getElementById(id).scrollIntoView(); // there was nothing to scroll to before
      return true;
    };
    addEventListener("hashchange", follow);
    if (!follow()) show_case(cases[0].id);
  }

  // Paper has nothing to click.
  let opened = [];
  addEventListener("beforeprint", () => {
    opened = [...document.querySelectorAll("details:not([open])")];
    for (const details of opened) {
      details.group = details.getAttribute("name"); // of which one alone is open
      details.removeAttribute("name");
      details.open = true;
    }
  });
  addEventListener("afterprint", () => {
    for (const details of opened) {
      details.open = false;
      if (details.group) details.setAttribute("name", details.group);
    }
  });

  // Filter
  const members = [...document.querySelectorAll("[data-key]")].map((span) => {
    const button = element("button", { type: "button", className: "member" }, ...span.childNodes);
    button.dataset.key = span.dataset.key;
    span.replaceWith(button);
    return button;
  });
  const every = members.map((button) => button.dataset.key);
  function apply() {
    for (const button of members) button.setAttribute("aria-pressed", String(!unghost.hidden.has(button.dataset.key)));
    for (const shown of document.querySelectorAll("svg [data-mode], tr[data-mode], details[data-mode]"))
      shown.classList.toggle("off", unghost.hidden.has(shown.dataset.mode));
    unghost.changed();
  }
  function hide(modes) {
    unghost.hidden = new Set(modes);
    apply();
  }
  unghost.toggle = (mode) => {
    if (!unghost.hidden.delete(mode)) unghost.hidden.add(mode);
    apply();
  };
  // Alone, and back
  unghost.solo = (mode) => {
    const others = every.filter((other) => other !== mode);
    hide(others.every((other) => unghost.hidden.has(other)) ? [] : others);
  };
  for (const button of members) button.addEventListener("click", () => unghost.toggle(button.dataset.key));
  if (members.length > 0) {
    const all = element("button", { type: "button", textContent: "all" });
    const none = element("button", { type: "button", textContent: "none" });
    all.addEventListener("click", () => hide([]));
    none.addEventListener("click", () => hide(every));
    document.getElementById("key").append(element("div", { className: "hint" },
      "Click a mode to hide it in charts and tables, a point to see its mode alone; the front stays that of all. Show ", all, " or ", none, "."));
    apply();
  }

  // Tables that sort by a click on a head; a second one turns the order round.
  function value_of(row, column) {
    const cell = row.cells[column];
    if (!("value" in cell.dataset)) return cell.textContent.trim();
    return cell.dataset.value === "" ? NaN : Number(cell.dataset.value);
  }
  function compare(a, b) {
    if (typeof a === "string") return a.localeCompare(b, "en");
    return Number.isNaN(a) ? 1 : Number.isNaN(b) ? -1 : a - b; // nothing measured: last
  }
  function sort(table, head) {
    const falling = head.getAttribute("aria-sort") === "ascending";
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", falling ? "descending" : "ascending");
    const order = (a, b) => {
      const [x, y] = [value_of(a, head.cellIndex), value_of(b, head.cellIndex)];
      return falling && !Number.isNaN(x) && !Number.isNaN(y) ? compare(y, x) : compare(x, y);
    };
    table.tBodies[0].append(...[...table.tBodies[0].rows].sort(order));
  }
  for (const table of document.querySelectorAll("table.sortable"))
    for (const head of table.tHead.rows[0].cells) {
      const button = element("button", { type: "button" }, ...head.childNodes);
      head.append(button);
      button.addEventListener("click", () => sort(table, head));
    }
})();
