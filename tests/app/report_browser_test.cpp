// The report in a browser: headless Chromium, without a network.
#include <cstdlib>

#include <gtest/gtest.h>

#include "app/files.h"
#include "app/measure/report/ablation.h"
#include "app/measure/report/embedded.h"
#include "tests/app/report_sample.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

struct Shown {
  std::string document, messages; // after the scripts; what the console says
};

class ReportBrowser : public testing::Test {
protected:
  void SetUp() override {
    if (std::system("command -v chromium >/dev/null") != 0) GTEST_SKIP() << "chromium is not installed";
    if (report_files::chart_js.text.empty()) GTEST_SKIP() << "built without Chart.js (libjs-chart.js)";
    page = report_page(ReportSample({"pass", "drive"}).results, ReportSample::picture, {});
  }

  std::string text_of(const char* name) const {
    const std::vector<uint8_t> bytes = read_file(folder.path / name, 1 << 26);
    return {bytes.begin(), bytes.end()};
  }

  Shown show(const std::string& html) const {
    const std::string file = folder.file("page.html", html), at = "'" + folder.path.string() + "/";
    const std::string command =
        "timeout 120 chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr"
        " --window-size=1280,2000 --virtual-time-budget=5000 --user-data-dir=" +
        at + "profile' --dump-dom 'file://" + file + "' >" + at + "dom' 2>" + at + "log'";
    EXPECT_EQ(std::system(command.c_str()), 0) << text_of("log");
    Shown shown{text_of("dom"), {}};
    std::istringstream log(text_of("log"));
    for (std::string line; std::getline(log, line);)
      if (line.find("CONSOLE") != std::string::npos) shown.messages += line + "\n";
    return shown;
  }

  /// What a script says that drives the page: lines of `name=value`. The policy would not let it run.
  Shown drive(const std::string& script) const {
    std::string open = page;
    const size_t policy = open.find("<meta http-equiv=\"Content-Security-Policy\"");
    // frames are not drawn in virtual time, or late: what waits for one waits for a moment
    open.replace(
        policy, open.find('>', policy) + 1 - policy,
        "<script>requestAnimationFrame = (then) => setTimeout(() => then(performance.now()), 1);</script>");
    open.insert(open.rfind("</body>"),
                "<pre id=\"said\"></pre><script>const say = (name, value) => {"
                "document.getElementById('said').textContent += `${name}=${value};`; };" +
                    script + "</script>");
    return show(open);
  }

  ScratchFolder folder;
  std::string page;
};

TEST_F(ReportBrowser, OpensWithoutAWordOnTheConsole) {
  const Shown shown = show(page);
  EXPECT_EQ(shown.messages, "");
  EXPECT_NE(shown.document.find("<canvas"), std::string::npos);
  EXPECT_NE(shown.document.find("type=\"range\""), std::string::npos);
}

// So that the test above can fail.
TEST_F(ReportBrowser, SaysSoWhereThePolicyDoesNotFit) {
  const size_t hash = page.find("script-src 'sha256-") + 19;
  page[hash] = page[hash] == 'A' ? 'B' : 'A';
  const Shown shown = show(page);
  EXPECT_NE(shown.messages.find("Content Security Policy"), std::string::npos) << shown.messages;
}

TEST_F(ReportBrowser, ChartsAreAliveAndTheFilterHidesAMode) {
  const Shown shown = drive(R"js(
    const visible = () => [...document.querySelectorAll("section.case:not(.off) .sheet")];
    say("sheets", visible().length);
    say("canvases", visible().filter((sheet) => sheet.querySelector("canvas").width > 0).length);
    const chart = unghost.chart_of("case-1-error");
    const at = chart.data.datasets.findIndex((set) => set.mode === "rgb");
    say("before", chart.isDatasetVisible(at));
    const button = document.querySelector("button[data-key=rgb]"), row = document.querySelector("#case-1 tr[data-mode=rgb]");
    button.click();
    say("after", chart.isDatasetVisible(at) + "," + button.getAttribute("aria-pressed") + "," + row.getClientRects().length);
    button.click();
    say("again", chart.isDatasetVisible(at) + "," + button.getAttribute("aria-pressed") + "," + row.getClientRects().length);
    document.querySelector(".cases a[href='#case-2']").click();
    say("case", [...document.querySelectorAll("section.case:not(.off)")].map((section) => section.id)); )js");
  EXPECT_EQ(shown.messages, "");
  for (const char* said :
       {"sheets=9;canvases=9;", "before=true;", "after=false,false,0;", "again=true,true,1;", "case=case-2;"})
    EXPECT_NE(shown.document.find(said), std::string::npos) << said;
}

TEST_F(ReportBrowser, HoveringNamesTheModeAndAClickLeavesItAlone) {
  const Shown shown = drive(R"js(
    const chart = unghost.chart_of("case-1-error");
    const at = chart.data.datasets.findIndex((set) => set.mode === "dop32-var");
    const point = chart.getDatasetMeta(at).data[0], box = chart.canvas.getBoundingClientRect();
    const send = (type) => chart.canvas.dispatchEvent(new MouseEvent(type,
      { clientX: box.left + point.x, clientY: box.top + point.y, bubbles: true }));
    const wait = setInterval(() => { // Chart.js answers with the next frame
      send("mousemove");
      if (!(chart.tooltip.opacity > 0)) return;
      clearInterval(wait);
      say("tooltip", chart.tooltip.body.map((part) => part.lines).join());
      send("click");
      setTimeout(() => say("alone", chart.data.datasets.filter((set, i) => set.mode && chart.isDatasetVisible(i)).map((set) => set.mode)), 100);
    }, 50); )js");
  EXPECT_EQ(shown.messages, "");
  EXPECT_NE(shown.document.find("tooltip=dop32-var: error 0.0"), std::string::npos);
  EXPECT_NE(shown.document.find("alone=dop32-var;"), std::string::npos)
      << shown.document.substr(shown.document.find("id=\"said\""), 300);
}

TEST_F(ReportBrowser, AnAddressInsideACaseShowsThatCaseAndPaperShowsAll) {
  const Shown shown =
      drive("const hidden = () => document.querySelector('#case-2').classList.contains('off');"
            "say('before', hidden()); location.hash = '#case-2-error';"
            "setTimeout(() => { say('after', hidden());"
            "  const closed = () => document.querySelectorAll('details:not([open])').length;"
            "  const before = closed(); dispatchEvent(new Event('beforeprint')); say('closed', closed());"
            "  dispatchEvent(new Event('afterprint')); say('as_before', closed() === before && before > 0); "
            "}, 300);");
  for (const char* said : {"before=true;", "after=false;", "closed=0;", "as_before=true;"})
    EXPECT_NE(shown.document.find(said), std::string::npos) << said;
}

TEST_F(ReportBrowser, AHeadSortsItsColumnBothWays) {
  const Shown shown = drive("const rows_of_modes = " + std::to_string(taa_modes().size()) + ";" + R"js(
    const table = document.querySelector("#case-1 table.sortable"), heads = [...table.tHead.rows[0].cells];
    const head = heads.find((cell) => cell.textContent.startsWith("error"));
    const sorted = (turn) => {
      const values = [...table.tBodies[0].rows].map((row) => turn * Number(row.cells[head.cellIndex].dataset.value));
      return values.length === rows_of_modes && values.every((value, i) => i === 0 || values[i - 1] <= value);
    };
    say("first", sorted(1) + "," + sorted(-1));
    head.querySelector("button").click();
    say("rising", sorted(1) + "," + head.getAttribute("aria-sort"));
    head.querySelector("button").click();
    say("falling", sorted(-1) + "," + head.getAttribute("aria-sort"));
    const over = heads.find((cell) => cell.textContent.startsWith("resolve, over a copy"));
    over.querySelector("button").click();
    over.querySelector("button").click();
    say("last", [...table.tBodies[0].rows].at(-1).dataset.mode);
    heads[0].querySelector("button").click();
    say("name", table.tBodies[0].rows[0].dataset.mode); )js");
  EXPECT_EQ(shown.messages, "");
  for (const char* said :
       {"first=false,false;", "rising=true,ascending;", "falling=true,descending;", "last=off;", "name=ac4;"})
    EXPECT_NE(shown.document.find(said), std::string::npos) << said;
}

TEST_F(ReportBrowser, TheSliderMovesAndShowsWhatIsChosen) {
  const Shown shown = drive(R"js(
    const slider = document.querySelector("#case-1 .slider"), range = slider.querySelector("input[type=range]");
    const over = slider.querySelector("img.over"), [left, right] = slider.querySelectorAll("select");
    range.value = 25;
    range.dispatchEvent(new Event("input"));
    say("clip", over.style.clipPath);
    say("choices", left.options.length + "," + right.value);
    const still = (kind, mode) => document.querySelector(`#case-1 img[data-${kind}="${mode}"]`).src;
    left.value = "rgb";
    left.dispatchEvent(new Event("change"));
    say("picture", over.src === still("picture", "rgb"));
    const maps = slider.querySelector("input[type=checkbox]");
    maps.click();
    say("map", over.src === still("map", "rgb"));
    left.value = "reference";
    left.dispatchEvent(new Event("change"));
    say("reference", over.src === still("picture", "reference")); )js");
  EXPECT_EQ(shown.messages, "");
  const std::string choices = std::to_string(taa_modes().size() + 1); // the reference, too
  for (const std::string& said :
       {std::string("clip=inset(0px 75% 0px 0px);"), "choices=" + choices + ",unghost;",
        std::string("picture=true;"), std::string("map=true;"), std::string("reference=true;")})
    EXPECT_NE(shown.document.find(said), std::string::npos) << said;
}

TEST_F(ReportBrowser, TheTablesOfPartsFitThePage) {
  ReportSample sample({"pass"});
  Measured& m = sample.results.scenes.front();
  MeasuredMode& base = *std::ranges::find(m.rows, ablated_row, &MeasuredMode::mode);
  base.figures["added_over_copy"] = 5.85; // all that a report shows
  const MeasuredMode row = base;
  for (const Part& part : parts()) {
    m.rows.push_back(row);
    m.modes.emplace_back(m.rows.back().mode = name_without(part), nlohmann::json::object());
    for (auto& [figure, value] : m.rows.back().figures) value *= 5; // +400%
    for (auto& [figure, samples] : m.rows.back().samples)
      for (double& one : samples) one *= 5;
  }
  page = report_page(sample.results, ReportSample::picture, {});
  const Shown shown = drive(R"js(
    const table = document.querySelector("table.variants"), room = table.parentElement;
    say("columns", table.tHead.rows[0].cells.length);
    say("fits", room.scrollWidth <= room.clientWidth && table.rows.length > 10); )js");
  EXPECT_EQ(shown.messages, "");
  EXPECT_NE(shown.document.find("columns=12;fits=true;"), std::string::npos)
      << shown.document.substr(shown.document.find("id=\"said\""), 300);
}

// Names from files, where a browser would act on them.
TEST_F(ReportBrowser, RunsNothingThatAFileNames) {
  ReportSample sample({"pass"});
  Measured& m = sample.results.scenes.front();
  const std::string evil = "<img src=x onerror=\"document.title='caught'\">";
  m.scene = m.rows[1].mode = m.modes[1].first = m.kept[1].mode = m.kept[2].mode = evil;
  page = report_page(sample.results, ReportSample::picture, {});
  EXPECT_EQ(show(page).messages, "");
  const Shown shown = drive("setTimeout(() => say('title', document.title.startsWith('unghost')), 500);");
  EXPECT_NE(shown.document.find("title=true;"), std::string::npos);
  EXPECT_EQ(shown.document.find("<img src=\"x\""), std::string::npos);
}

} // namespace
} // namespace unghost
