package badlog.report.page

import badlog.exporter.HtmlExporter
import badlog.exporter.PageParts
import badlog.files.inFolder
import badlog.page.Chromium
import badlog.page.OpenPage
import badlog.page.Screen
import badlog.page.seriousForReaders
import badlog.report.Report
import badlog.report.batteryBag
import badlog.report.logsIn
import badlog.report.put
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name
import kotlin.io.path.nameWithoutExtension

private const val SVG = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 900 420\" width=\"900\" height=\"420\"><rect width=\"900\" height=\"420\" fill=\"green\"/></svg>"

private fun chart(name: String) = PageChart(name, "Battery & <co>", "Is it “low”?", "band: the middle half", SVG, byteArrayOf(1, 2, 3))

private val CHARTS = PageCharts(listOf(chart("battery"), chart("loop-times")), listOf("“Packet loss” needs <b>."))

/** The charts on the index page of a report. */
@Tags("InCheck")
class PageChartsSpec : FunSpec({
    /** Writes a report with [charts] of one log into [out]. */
    fun report(folder: Path, out: Path, charts: PageCharts, isForced: Boolean = false, leaveOut: (String) -> Unit = { error(it) }): Path {
        folder.put("logs/Q1.bag", batteryBag(6.0))
        val logs = logsIn(folder.resolve("logs"))
        val pages = ReportFolder(out, logs, RuleSet.NONE, isForced = isForced, exporter = HtmlExporter(parts = PageParts("", "")))
        return pages.writeIndex(Report(RuleSet.NONE).over(logs), charts = charts, leaveOut = leaveOut)
    }

    test("each chart is two files beside the index, which shows the one and links both") {
        inFolder { folder ->
            val index = Files.readString(report(folder, folder.resolve("out"), CHARTS))
            index shouldContain "<img src=\"charts/battery.svg\" alt=\"Battery &amp; &lt;co&gt;. Is it “low”? band: the middle half\""
            index shouldContain "<a href=\"charts/loop-times.png\">PNG</a>"
            index shouldContain "<li>“Packet loss” needs &lt;b&gt;.</li>"
            index shouldContain "default-src 'none'; img-src 'self'; style-src"
            Files.readString(folder.resolve("out/charts/battery.svg")) shouldContain SVG
            Files.readAllBytes(folder.resolve("out/charts/battery.png")).size shouldBe 3
        }
    }

    test("a report without charts allows no pictures, and has no folder of them") {
        inFolder { folder ->
            val index = Files.readString(report(folder, folder.resolve("out"), PageCharts.NONE))
            index shouldNotContain "img-src"
            index shouldNotContain "<h2>Charts</h2>"
            Files.exists(folder.resolve("out/charts")) shouldBe false
        }
    }

    test("charts that badlog made are replaced, and files of others only if forced") {
        inFolder { folder ->
            val out = folder.resolve("out")
            repeat(2) { report(folder, out, CHARTS) }
            for (name in listOf("battery.svg", "loop-times.png")) {
                val other = if (name.endsWith("png")) out.resolve("charts/loop-times.svg") else out.resolve("charts/$name")
                Files.writeString(other, "<svg>mine</svg>")
                val leftOut = ArrayList<String>()
                // The chart alone is left out.
                val index = Files.readString(report(folder, out, CHARTS, leaveOut = leftOut::add))
                leftOut.single() shouldContain "badlog did not make it"
                Regex("<img src=\"charts/([a-z-]+)").findAll(index).map { it.groupValues[1] }.toList() shouldBe
                    CHARTS.all.map { it.name } - other.nameWithoutExtension
                Files.readString(other) shouldBe "<svg>mine</svg>"
                report(folder, out, CHARTS, isForced = true)
            }
        }
    }

    test("a picture without its other file is not known as badlog’s, and only its chart is left out") {
        inFolder { folder ->
            val out = folder.resolve("out")
            report(folder, out, CHARTS)
            Files.delete(out.resolve("charts/battery.svg"))
            val leftOut = ArrayList<String>()
            Files.readString(report(folder, out, CHARTS, leaveOut = leftOut::add)) shouldContain "charts/loop-times.svg"
            leftOut.single() shouldContain "battery.png exists already"
        }
    }

    test("only former charts that are no longer drawn are removed") {
        inFolder { folder ->
            val out = folder.resolve("out")
            report(folder, out, CHARTS)
            Files.writeString(out.resolve("charts/resistance.svg"), "<svg>mine</svg>")
            Files.copy(out.resolve("charts/loop-times.svg"), out.resolve("charts/of last year.svg"))
            report(folder, out, PageCharts(listOf(chart("battery")), listOf("“Loop times” needs more."), listOf("loop-times", "resistance", "packet-loss")))
            Files.list(out.resolve("charts")).use { all -> all.map { it.name }.sorted().toList() } shouldBe
                listOf("battery.png", "battery.svg", "of last year.svg", "resistance.svg")
        }
    }

    test("a browser shows the charts from the disk, without a network").config(enabledOrReasonIf = { Chromium.enabled }) {
        inFolder { folder ->
            val index = report(folder, folder.resolve("out"), CHARTS)
            OpenPage.open(index, Screen.WIDE, script = null).use { page ->
                page.settle()
                page.script("return Array.from(document.images).map(i => i.complete ? i.naturalWidth : 0).join()") shouldBe "900,900"
                page.consoleMessages().shouldBeEmpty()
                page.requests().filterNot { it.startsWith("file:") }.shouldBeEmpty()
                page.seriousForReaders().shouldBeEmpty()
            }
        }
    }
})
