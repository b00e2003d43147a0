// SPDX-License-Identifier: LGPL-2.1-or-later
// Draws the figures with plotly.js, which the page holds packed, and plays the chain. Where a browser cannot unpack or draw, the still
// pictures stay.
"use strict";
(() => {
  const root = document.documentElement;
  const dashes = ["solid", "dash", "dot", "dashdot", "longdash"];
  const coarse = matchMedia("(pointer: coarse)").matches;

  async function unpack(id) {
    const bytes = Uint8Array.from(atob(document.getElementById(id).textContent.trim()), c => c.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
  }

  const style = name => getComputedStyle(root).getPropertyValue(name).trim();
  const color = number => style("--c" + number % 8);
  const numbers = x => Array.isArray(x) ? x : Array.from({length: x.n}, (_, i) => x.first + i * x.step);

  function traces(panel) {
    const all = [];
    for (const c of panel.c) {
      const x = numbers(c.x), named = {name: c.n, meta: c.n, showlegend: false, hovertemplate: `%{x:.6~g}, %{y:.5~g}<extra>${c.n}</extra>`};
      if (c.k === "bars") all.push({...named, type: "bar", x, y: c.y, marker: {color: color(c.c)}});
      else if (c.k === "points") all.push({...named, mode: "markers", x, y: c.y, marker: {color: color(c.c), size: 7, symbol: c.d % 5}});
      else if (c.k === "band") {
        all.push({...named, x, y: c.l, mode: "lines", line: {width: 0}, hoverinfo: "skip"});
        all.push({...named, x, y: c.y, mode: "lines", line: {width: 0}, fill: "tonexty", fillcolor: color(c.c) + "38", hoverinfo: "skip"});
      } else all.push({...named, x, y: c.y, mode: "lines", line: {color: color(c.c), width: c.w, dash: dashes[c.d % 5]}});
    }
    return all;
  }

  function ticks([low, high]) {
    const values = [], steps = high / low < 200 ? [1, 2, 5] : [1];
    for (let e = Math.floor(Math.log10(low)); e <= Math.log10(high); ++e) values.push(...steps.map(s => s * 10 ** e));
    return {tickvals: values, ticktext: values.map(v => v >= 1e5 || v < 1e-3 ? v.toExponential(0).replace("e", "·10<sup>").replace("+", "") + "</sup>" : String(+v.toPrecision(2)))};
  }

  function layout(panel) {
    const axis = (title, range, log) => ({
      title: {text: title, standoff: 8}, range: log ? range.map(Math.log10) : range, type: log ? "log" : "linear", gridcolor: style("--grid"),
      zeroline: false, linecolor: style("--line"), automargin: true, ...(log ? ticks(range) : {})
    });
    return {
      margin: {l: 58, r: 10, t: 8, b: 44}, paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)", hovermode: "closest",
      font: {family: getComputedStyle(document.body).fontFamily, size: 12, color: style("--soft")},
      dragmode: coarse ? false : "zoom", modebar: {bgcolor: "rgba(0,0,0,0)", color: style("--c7"), activecolor: style("--accent")}, bargap: 0.2,
      xaxis: axis(panel.x, panel.xr, panel.xl), yaxis: axis(panel.y, panel.yr, panel.yl),
      shapes: panel.m.map(([x]) => ({type: "line", x0: x, x1: x, yref: "paper", y0: 0, y1: 1, line: {color: style("--soft"), width: 1, dash: "dot"}})),
      annotations: panel.m.map(([x, text]) => ({x: panel.xl ? Math.log10(x) : x, yref: "paper", y: 1, text, showarrow: false, textangle: -90, xanchor: "right", yanchor: "top",
        font: {size: 10}}))
    };
  }

  function draw(div, panel) {
    const all = traces(panel), hidden = div.hidden_names || new Set();
    all.forEach(t => { if (hidden.has(t.meta)) t.visible = false; });
    div.classList.add("drawn");
    return Plotly.react(div, all, layout(panel), {responsive: true, displaylogo: false, displayModeBar: coarse ? false : "hover", modeBarButtonsToRemove: ["lasso2d", "select2d", "autoScale2d"]});
  }

  function legend(list, plots) {
    for (const button of list.querySelectorAll("button")) {
      button.onclick = () => {
        const on = button.getAttribute("aria-pressed") === "false";
        button.setAttribute("aria-pressed", on);
        for (const div of plots) {
          div.hidden_names = div.hidden_names || new Set();
          div.hidden_names[on ? "delete" : "add"](button.textContent.trim());
          Plotly.restyle(div, {visible: div.data.map(t => !div.hidden_names.has(t.meta))});
        }
      };
    }
  }

  // ---- the chain in motion

  function film(box, data) {
    const canvas = box.querySelector("canvas"), pen = canvas.getContext("2d");
    const slider = box.querySelector("input"), play = box.querySelector("button"), view = box.querySelector("select"), clock = box.querySelector("output");
    const n = data.time.length, links = data.x[0].length, span = data.high - data.low || 1;
    let frame = n - 1, timer = null;
    slider.max = n - 1;
    view.append(...data.sprockets.map(s => new Option(s.title, s.name)));

    function shade(value) {
      const stops = matchMedia("(prefers-color-scheme: dark)").matches ? data.dark : data.light, place = Math.min(Math.max(value, 0), 1) * (stops.length - 1), k = Math.min(Math.floor(place), stops.length - 2);
      return "rgb(" + stops[k].map((a, i) => Math.round(a + (stops[k + 1][i] - a) * (place - k))).join(",") + ")";
    }

    // where the chain is in any frame: it may hang below all sprockets
    const extent = rows => rows.reduce((e, row) => [Math.min(e[0], ...row), Math.max(e[1], ...row)], [Infinity, -Infinity]);
    const chain = [...extent(data.x), ...extent(data.y)].map((value, i) => value / 100 + (i % 2 ? 1 : -1) * 1.5 * data.roller);

    function bounds() {
      const still = data.sprockets.map(s => ({...s, x: at(s.x), y: at(s.y)}));
      const a = still[0], margin = 3 * data.roller, one = still.find(s => s.name === view.value);
      const around = s => [s.x - s.radius - margin, s.x + s.radius + margin, s.y - s.radius - margin, s.y + s.radius + margin];
      if (one === a) return [a.x - 1.8 * a.radius, a.x + 2.6 * a.radius, a.y - 1.5 * a.radius, a.y + 1.5 * a.radius];
      if (one) return around(one);
      const lines = data.guides.flatMap(g => [...g.x.map((x, k) => [at(x), at(g.y[k])]), ...(g.pivot ? [g.pivot] : [])]).map(([x, y]) => [x - 2, x + 2, y - 2, y + 2]);
      const all = [...still.map(around), ...lines, chain];
      return [Math.min(...all.map(r => r[0])), Math.max(...all.map(r => r[1])), Math.min(...all.map(r => r[2])), Math.max(...all.map(r => r[3]))];
    }

    const at = track => Array.isArray(track) ? track[frame] : track;

    function show() {
      const [left, right, low, high] = bounds(), ratio = devicePixelRatio || 1, width = box.clientWidth;
      if (!width) return;
      const height = Math.min(width * (high - low) / (right - left), 0.6 * innerHeight + 60), scale = Math.min(width / (right - left), height / (high - low));
      canvas.width = width * ratio; canvas.height = height * ratio; canvas.style.height = height + "px";
      pen.setTransform(ratio * scale, 0, 0, -ratio * scale, ratio * (width / 2 - scale * (left + right) / 2), ratio * (height / 2 + scale * (low + high) / 2));
      pen.lineJoin = pen.lineCap = "round";
      for (const about of data.sprockets) {
        const s = {...about, x: at(about.x), y: at(about.y)}, turn = s.angle[frame], pitch = 2 * Math.PI / s.teeth;
        pen.beginPath();
        if (!s.teeth) pen.arc(s.x, s.y, s.radius - data.roller, 0, 7);
        for (let k = 0; k < s.teeth; ++k) {
          const middle = turn + k * pitch;
          pen.arc(s.x + s.radius * Math.cos(middle), s.y + s.radius * Math.sin(middle), data.roller, middle + Math.PI + 1.05, middle + Math.PI - 1.05, true);
          for (const share of [0.43, 0.57]) {
            const at = middle + share * pitch, tip = s.radius + 0.45 * data.roller;
            pen.lineTo(s.x + tip * Math.cos(at), s.y + tip * Math.sin(at));
          }
        }
        pen.closePath();
        pen.fillStyle = style("--paper"); pen.fill();
        pen.lineWidth = Math.max(0.5, 1 / scale); pen.strokeStyle = style("--soft"); pen.stroke();
        pen.beginPath(); pen.moveTo(s.x, s.y); pen.lineTo(s.x + 0.55 * s.radius * Math.cos(turn), s.y + 0.55 * s.radius * Math.sin(turn)); pen.stroke();
      }
      pen.strokeStyle = style("--ink"); pen.lineWidth = Math.max(1.2, 2 / scale);
      for (const guide of data.guides) {
        pen.beginPath();
        guide.x.forEach((x, k) => pen.lineTo(at(x), at(guide.y[k])));
        if (guide.pivot) pen.lineTo(...guide.pivot);
        pen.stroke();
      }
      const x = data.x[frame], y = data.y[frame], tension = data.tension[frame];
      for (let k = 0; k < links; ++k) {
        const next = (k + 1) % links;
        pen.beginPath(); pen.moveTo(x[k] / 100, y[k] / 100); pen.lineTo(x[next] / 100, y[next] / 100);
        pen.lineWidth = Math.max((k % 2 ? 1.5 : 1.1) * data.roller, 2 / scale);
        pen.strokeStyle = shade((tension[k] - data.low) / span); pen.stroke();
      }
      pen.fillStyle = style("--paper"); pen.globalAlpha = 0.85;
      for (let k = 0; k < links; ++k) { pen.beginPath(); pen.arc(x[k] / 100, y[k] / 100, 0.45 * data.roller, 0, 7); pen.fill(); }
      pen.globalAlpha = 1;
      slider.value = frame;
      clock.textContent = (data.time[frame] / 1000).toFixed(2) + " ms";
    }

    function stop() { clearInterval(timer); timer = null; play.textContent = "Play"; }
    play.onclick = () => {
      if (timer) return stop();
      play.textContent = "Pause";
      timer = setInterval(() => { frame = (frame + 1) % n; show(); }, 50);
    };
    slider.oninput = () => { stop(); frame = Number(slider.value); show(); };
    view.onchange = show;
    addEventListener("resize", show);
    box.classList.add("drawn");
    show();
    return show;
  }

  async function main() {
    if (typeof DecompressionStream === "undefined") throw new Error("no DecompressionStream");
    const data = JSON.parse(await unpack("data"));
    const redraw = [];
    for (const box of document.querySelectorAll(".film")) redraw.push(film(box, data.films[box.dataset.film]));
    if (document.getElementById("plotly")) {
      const script = document.createElement("script");
      script.textContent = await unpack("plotly");
      document.head.append(script);
      for (const figure of document.querySelectorAll("figure")) {
        const plots = [...figure.querySelectorAll(".live")], list = figure.querySelector(".key");
        for (const div of plots) {
          await new Promise(done => setTimeout(done));  // lets the reader scroll
          const panel = data.panels[div.dataset.panel];
          await draw(div, panel);
          redraw.push(() => draw(div, panel));
        }
        if (list && plots.length) legend(list, plots);
      }
    }
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => redraw.forEach(again => again()));
    root.dataset.state = "ready";
  }

  main().catch(error => { root.dataset.state = "still"; root.dataset.reason = error.message; });
})();
