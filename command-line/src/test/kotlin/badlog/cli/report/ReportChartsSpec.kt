package badlog.cli.report

import badlog.cli.BAG
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.command.LogFiles
import badlog.cli.command.Outcomes
import badlog.cli.command.ResultForm
import badlog.cli.console.Console
import badlog.cli.names
import badlog.cli.plugin.ChartService
import badlog.cli.plugin.PluginLoader
import badlog.cli.search.Search
import badlog.cli.with
import badlog.files.inFolder
import badlog.report.Report
import badlog.report.page.ReportFolder
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.awt.AWTError
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.ServiceLoader
import javax.imageio.ImageIO
import kotlin.io.path.div
import kotlin.io.path.readBytes
import kotlin.io.path.readText

@Tags("InCheck")
class ReportChartsSpec : FunSpec({
    test("charts of the samples are written beside the index, and missing data for others is reported") {
        inFolder { folder ->
            val ended = badlog("report", SAMPLES, "--out", folder / "report", "--charts", "--no-cache")
            // Two of them are damaged on purpose.
            ended.code shouldBe ExitCode.SALVAGED
            ended.err shouldContain "“Packet loss” needs the share of lost packets in at least 3 logs; no log shows it."
            val charts = (folder / "report/charts").names()
            charts shouldContainAll listOf("battery.png", "battery.svg", "loop-times.svg", "loops-per-match.svg", "battery-over-current.svg", "resistance.svg")
            (folder / "report/index.html").readText() shouldContain "<img src=\"charts/battery.svg\""
            val svg = (folder / "report/charts/battery.svg").readText()
            for (match in listOf("Q42", "Q57")) svg shouldContain match
            svg shouldNotContain "<script"
            ImageIO.read(ByteArrayInputStream((folder / "report/charts/battery.png").readBytes())).width shouldBe 1800
        }
    }

    test("charts do not need a rule that compares logs, nor a cache, and are the same from the cache") {
        inFolder { folder ->
            val rules = folder.with("r.toml", "[[rule]]\nname='R'\nseverity='note'\nwhen='min(battery) < 1'\ntext='x'")

            // Pictures: each document has names of its own for its parts.
            fun chart(out: String, cache: Path?): List<Byte> {
                val console = Console(PrintStream(ByteArrayOutputStream()), PrintStream(ByteArrayOutputStream()), false)
                val plan = PagesPlan(folder / out, isForced = false, field = null, hasCharts = true)
                val search = Search(rules, isWithoutRules = false, emptyList(), emptyList())
                ReportTask(listOf(SAMPLES), search, ResultForm.TEXT, plan, cache, null, null, PluginLoader.ofProgram()).run(console)
                return (folder / out / "charts/battery.png").readBytes().toList()
            }
            val cache = folder / "cache"
            val uncached = chart("uncached", cache = null)
            (chart("first", cache) == uncached) shouldBe true
            val stored = Files.walk(cache).use { all -> all.filter(Files::isRegularFile).toList() }
            stored.shouldNotBeEmpty()
            (chart("second", cache) == uncached) shouldBe true
            // It was all there.
            Files.walk(cache).use { all -> all.filter(Files::isRegularFile).toList() } shouldContainExactlyInAnyOrder stored
        }
    }

    test("a failure in drawing leaves out the charts, not the index") {
        inFolder { folder ->
            folder.with("logs/a.bag", BAG)
            for (failure in listOf(NoClassDefFoundError("java/awt/Font"), AWTError("no screen"), IllegalStateException("no chart"), IOException("no room"))) {
                val err = ByteArrayOutputStream()
                val console = Console(PrintStream(ByteArrayOutputStream()), PrintStream(err, true, "UTF-8"), false)
                val (logs, outcomes) = LogFiles(listOf(folder / "logs"), console) to Outcomes("report", console, isJson = false)
                val pages = ReportPages(ReportFolder(folder / failure.javaClass.simpleName, logs.files, RuleSet.NONE))
                pages.finish(Report(RuleSet.NONE).over(logs.files), outcomes) { throw failure }
                err.toString(Charsets.UTF_8) shouldContain "Charts cannot be drawn, so the index has none: ${failure.message}"
                pages.index!!.readText() shouldNotContain "charts/"
            }
        }
    }

    test("charts are drawn without a screen, and their last one is reported as done") {
        val before = System.clearProperty("java.awt.headless")
        try {
            val seen = ArrayList<Pair<Int, Int>>()
            ServiceLoader.load(ChartService::class.java).first().chartsOf(emptyList()) { done, total -> seen += done to total }.undrawn.size shouldBe 7
            seen shouldBe listOf(0 to 0)
            System.getProperty("java.awt.headless") shouldBe "true"
        } finally {
            if (before != null) System.setProperty("java.awt.headless", before)
        }
    }

    test("logs without the data of a chart get no chart, with a reason for each") {
        inFolder { folder ->
            folder.with("logs/a.bag", BAG)
            val ended = badlog("report", folder / "logs", "--out", folder / "report", "--charts", "--no-cache")
            ended.err shouldContain "“Battery at its lowest” needs the battery’s voltage in at least 3 logs; no log shows it."
            Files.exists(folder / "report/charts") shouldBe false
            (folder / "report/index.html").readText() shouldContain "needs the battery’s voltage"
            badlogJson("report", folder / "logs", "--out", folder / "report", "--charts", "--no-cache").err shouldNotContain "needs the battery"
        }
    }

    test("charts need a folder, and never replace other files") {
        inFolder { folder ->
            badlog("report", SAMPLES, "--charts").run {
                code shouldBe ExitCode.USAGE
                err shouldContain "--charts needs --out"
            }
            folder.with("report/charts/battery.svg", "mine")
            badlog("report", SAMPLES, "--out", folder / "report", "--charts", "--no-cache").run {
                code shouldBe ExitCode.SALVAGED
                err shouldContain "battery.svg exists already, and badlog did not make it"
            }
            (folder / "report/charts/battery.svg").readText() shouldBe "mine"
            (folder / "report/index.html").readText().let { index ->
                index shouldNotContain "charts/battery.svg"
                index shouldContain "charts/loop-times.svg"
            }
        }
    }
})
