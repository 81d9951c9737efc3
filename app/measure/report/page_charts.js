"use strict";
// Chart.js in place of the static charts on a screen; print shows those. Positions are 0 to 1 on both axes.
(() => {
  const radius = { point: 6, line: 3.5, reference: 3, strip: 1.8, front: 0, whisker: 0, box: 0 };
  const width = { line: 1.5, reference: 1.6, front: 1.6, whisker: 1.5, box: 8 };
  // Chart.js's shape, its turn, and how much larger to draw it to look as large as the others
  const shapes = [["circle", 0, 0.85], ["rect", 0, 1.1], ["triangle", 0, 1.05], ["rectRot", 0, 1.1], ["triangle", 180, 1.05], ["cross", 0, 1]];
  const live = new Map(); // figure to its chart

  function colours() {
    const style = getComputedStyle(document.documentElement);
    const of = (name) => style.getPropertyValue("--" + name).trim();
    return { of, ink: of("ink"), soft: of("soft"), grid: of("grid"), paper: of("paper") };
  }
  function dataset(series, colour, rows) {
    const mine = series.family < 0 ? (series.mark === "front" ? colour.ink : colour.soft) : colour.of("f" + series.family);
    const [style, turned, larger] = shapes[series.shape];
    const cross = style === "cross", alone = series.mark === "strip" && series.points.length === 1;
    const size = larger * (alone ? 3.5 : rows > 0 && series.mark === "point" ? 5 : radius[series.mark]);
    return {
      label: series.name, mode: series.mode, mark: series.mark,
      data: series.points.map(([x, y, note, best, name]) => ({ x, y, note, best, name })),
      showLine: series.mark in width,
      borderWidth: width[series.mark] || 1,
      borderColor: series.mark === "box" ? mine + "73" : series.mark in width ? mine : colour.paper,
      borderDash: series.mark === "reference" ? [5, 4] : [],
      backgroundColor: mine, fill: false, clip: 12,
      pointStyle: style, rotation: turned,
      pointRadius: size, hitRadius: size ? 5 : 0,
      pointHoverRadius: size ? size + 2 : 0,
      pointBackgroundColor: series.mark === "strip" && !alone ? mine + "80" : mine,
      pointBorderColor: cross ? mine : series.points.map((point) => point[3] ? colour.ink : colour.paper),
      pointBorderWidth: series.mark === "strip" ? 0 : cross ? 3 : series.points.map((point) => point[3] ? 1.6 : 1),
      order: { point: 0, line: 1, strip: 2, box: 4, whisker: 3, reference: 5, front: 6 }[series.mark],
    };
  }
  function axis(of, colour, position) {
    return {
      type: "linear", position, min: 0, max: 1,
      title: { display: of.label !== "", text: of.label, color: colour.soft, font: { size: 11 } },
      afterBuildTicks: (scale) => { scale.ticks = of.ticks.map(([value, label]) => ({ value, label })); },
      ticks: { color: colour.soft, font: { size: 11 }, autoSkip: of.rows === 0, maxRotation: 0, callback: (v, i, all) => all[i].label },
      grid: { color: colour.grid, borderColor: colour.soft, drawTicks: false },
    };
  }

  // Names beside the points, as the static charts have them: those on the front choose first.
  function overlap(a, b) {
    const w = Math.min(a.x + a.w, b.x + b.w) - Math.max(a.x, b.x), h = Math.min(a.y + a.h, b.y + b.h) - Math.max(a.y, b.y);
    return w > 0 && h > 0 ? w * h : 0;
  }
  function places(x, y, w) {
    return [9, 19, 31, 45].flatMap((gap) => [[x + gap, y - 6, 0], [x - w - gap, y - 6, 2],
      ...[y - gap - 11, y + gap - 1].flatMap((top) => [[x - w / 2, top, 3], [x + 4, top, 3], [x - w - 4, top, 4]])]
      .map(([left, top, cost]) => ({ x: left, y: top, w, h: 12, cost: cost + gap, far: gap > 19 })));
  }
  function ends(named) {
    const sorted = [...named].sort((a, b) => a.y - b.y);
    for (const name of sorted) name.top = name.y - 6;
    for (let round = 0; round < 400; ++round)
      for (let i = 1; i < sorted.length; ++i) {
        const lack = 12 - (sorted[i].top - sorted[i - 1].top);
        if (lack > 0.1) sorted[i].top += lack / 2, sorted[i - 1].top -= lack / 2;
      }
  }
  function along(points) {
    const boxes = [];
    for (let i = 1; i < points.length; ++i) {
      const [a, b] = [points[i - 1], points[i]], steps = Math.ceil(Math.hypot(b.x - a.x, b.y - a.y) / 4);
      for (let step = 0; step < steps; ++step)
        boxes.push({ x: a.x + (b.x - a.x) * step / steps - 2, y: a.y + (b.y - a.y) * step / steps - 2, w: 4, h: 4 });
    }
    return boxes;
  }
  function wanted(chart) {
    const named = [], taken = [];
    chart.data.datasets.forEach((set, i) => {
      if (!chart.isDatasetVisible(i)) return;
      const points = chart.getDatasetMeta(i).data;
      if (set.mark === "front" || set.mark === "reference") taken.push(...along(points));
      if (!["point", "line", "reference"].includes(set.mark)) return;
      if (set.mark === "point") for (const { x, y } of points) taken.push({ x: x - 6, y: y - 6, w: 12, h: 12 });
      set.data.forEach((raw, at) => {
        const text = raw.name || (at === set.data.length - 1 ? set.label : "");
        if (text) named.push({ text, x: points[at].x, y: points[at].y, best: raw.best, aside: set.mark === "reference" });
      });
    });
    return { named: named.sort((a, b) => Number(b.best) - Number(a.best) || a.y - b.y), taken };
  }
  function leader(ctx, name, x, y, colour) {
    ctx.strokeStyle = colour.soft, ctx.lineWidth = 0.6;
    ctx.beginPath(), ctx.moveTo(name.x, name.y), ctx.lineTo(x, y), ctx.stroke();
  }
  const names = {
    id: "names",
    afterDatasetsDraw(chart) {
      const { named: has_names, lines, narrow, breaks } = chart.options.plugins.names;
      const { ctx, chartArea: area } = chart, colour = colours();
      ctx.fillStyle = colour.ink, ctx.font = `11px ${Chart.defaults.font.family}`, ctx.textBaseline = "middle";
      for (const at of breaks) ctx.fillText("//", area.left + area.width * at - 3, area.bottom); // the scale begins anew
      if (!has_names) return;
      const { named, taken } = wanted(chart);
      ctx.save();
      ctx.textBaseline = "top";
      if (lines) ends(named);
      for (const name of named) {
        ctx.font = `${name.best ? "bold" : name.aside ? "italic" : "normal"} 11px ${Chart.defaults.font.family}`;
        const w = ctx.measureText(name.text).width;
        const outside = (p) => Math.max(0, area.left - p.x) + Math.max(0, p.x + w - chart.width) + Math.max(0, area.top - 6 - p.y) + Math.max(0, p.y + 12 - area.bottom);
        const cost = (p) => p.cost + 40 * outside(p) + taken.reduce((sum, other) => sum + overlap(p, other), 0);
        const place = lines ? { x: name.x + 14, y: name.top, w, h: 12, far: Math.abs(name.top + 6 - name.y) > 3 }
          : places(name.x, name.y, w).reduce((a, b) => cost(b) < cost(a) ? b : a);
        if (narrow && !name.best && cost(place) > 20) continue; // no room: hovering tells
        taken.push(place);
        if (place.far) leader(ctx, name, Math.max(place.x - 2, Math.min(name.x, place.x + w)), place.y + 6, colour);
        ctx.fillStyle = name.aside ? colour.soft : colour.ink;
        ctx.fillText(name.text, place.x, place.y);
      }
      ctx.restore();
    },
  };

  function options(chart, colour, sheet) {
    const rows = chart.y.rows > 0, narrow = sheet.clientWidth < 480;
    const count = chart.series.filter((series) => series.mark === "line").length, lines = count > 0;
    const named = !rows && !(narrow && count > 8); // on a phone the key above must do for many lines
    return {
      animation: false, responsive: true, maintainAspectRatio: false,
      layout: { padding: { right: lines && named ? 98 : 12, top: 4 } },
      interaction: { mode: "nearest", intersect: true },
      scales: { x: axis(chart.x, colour, "bottom"), y: axis(chart.y, colour, "left") },
      plugins: {
        names: { named, lines, narrow, breaks: chart.x.breaks }, legend: { display: false },
        tooltip: {
          filter: (item) => Boolean(item.raw.note), displayColors: false,
          backgroundColor: colour.ink, bodyColor: colour.paper,
          callbacks: { title: () => "", label: (item) => item.raw.note },
        },
      },
      onHover: (event, found) => { event.native.target.style.cursor = found.some((f) => mode_of(live.get(sheet), f)) ? "pointer" : ""; },
      onClick: (event, found) => {
        const mode = found.length > 0 ? mode_of(live.get(sheet), found[0]) : "";
        if (mode && !mode.includes(":")) unghost.solo(mode);
      },
    };
  }
  function mode_of(chart, found) { return chart ? chart.data.datasets[found.datasetIndex].mode : ""; }

  function make(figure) {
    const chart = unghost.data.charts[figure.id], sheet = figure.querySelector(".sheet"), colour = colours();
    const canvas = document.createElement("canvas");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", chart.title);
    const box = unghost.element("div", {}, canvas);
    box.style.height = (chart.y.rows > 0 ? 24 * chart.y.rows + 56 : Math.min(chart.wide ? 460 : 400, Math.max(320, sheet.clientWidth * 0.72))) + "px";
    sheet.append(box);
    sheet.classList.add("live");
    live.set(sheet, new Chart(canvas, {
      type: "scatter", plugins: [names],
      data: { datasets: chart.series.map((series) => dataset(series, colour, chart.y.rows)) },
      options: options(chart, colour, sheet),
    }));
  }
  function update() {
    for (const figure of document.querySelectorAll("section.case:not(.off) figure.plot")) {
      const sheet = figure.querySelector(".sheet");
      if (!live.has(sheet)) make(figure);
      const chart = live.get(sheet);
      chart.data.datasets.forEach((set, i) => chart.setDatasetVisibility(i, !unghost.hidden.has(set.mode)));
      chart.update("none");
    }
  }
  function again() {
    for (const [sheet, chart] of live) {
      chart.destroy();
      sheet.lastElementChild.remove();
      sheet.classList.remove("live");
    }
    live.clear();
    update();
  }
  unghost.chart_of = (id) => live.get(document.getElementById(id).querySelector(".sheet"));
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  unghost.watchers.push(update);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", again);
  update();
})();
