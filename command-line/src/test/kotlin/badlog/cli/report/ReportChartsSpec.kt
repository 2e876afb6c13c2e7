package badlog.cli.report

import badlog.cli.BAG
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.inFolder
import badlog.cli.names
import badlog.cli.with
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.io.ByteArrayInputStream
import java.nio.file.Files
import javax.imageio.ImageIO
import kotlin.io.path.div
import kotlin.io.path.readBytes
import kotlin.io.path.readText

class ReportChartsSpec : FunSpec({
    test("charts of the samples are written beside the index, and what is lacking for others is reported") {
        inFolder { folder ->
            val ended = badlog("report", SAMPLES, "--out", folder / "report", "--charts", "--no-cache")
            // Two of them are damaged on purpose.
            ended.code shouldBe ExitCode.SALVAGED
            ended.err shouldContain "“Packet loss” needs the share of lost packets in at least 3 logs; no log shows it."
            val charts = (folder / "report/charts").names()
            charts shouldContainAll listOf("battery.png", "battery.svg", "loop-times.svg", "loops-per-match.svg", "battery-over-current.svg", "resistance.svg")
            (folder / "report/index.html").readText() shouldContain "<img src=\"charts/battery.svg\""
            val svg = (folder / "report/charts/battery.svg").readText()
            for (match in listOf("Q42", "Q57", "practice")) svg shouldContain match
            svg shouldNotContain "<script"
            ImageIO.read(ByteArrayInputStream((folder / "report/charts/battery.png").readBytes())).width shouldBe 1800
        }
    }

    test("charts do not need a rule that compares logs, nor a cache, and are the same from the cache") {
        inFolder { folder ->
            val rules = folder.with("r.toml", "[[rule]]\nname='R'\nseverity='note'\nwhen='min(battery) < 1'\ntext='x'")
            badlog("report", SAMPLES, "--out", folder / "report", "--charts", "--no-cache", "--rules", rules)
            (folder / "report/charts").names() shouldContain "battery.svg"
        }
    }

    test("logs without what charts show have none, and each chart says why") {
        inFolder { folder ->
            folder.with("logs/a.bag", BAG)
            val ended = badlog("report", folder / "logs", "--out", folder / "report", "--charts", "--no-cache")
            ended.err shouldContain "“Battery at its lowest” needs the battery’s voltage in at least 3 logs; no log shows it."
            Files.exists(folder / "report/charts") shouldBe false
            (folder / "report/index.html").readText() shouldContain "needs the battery’s voltage"
            badlogJson("report", folder / "logs", "--out", folder / "report", "--charts", "--no-cache").err shouldNotContain "needs the battery"
        }
    }

    test("charts need a folder, and never replace what badlog did not make") {
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
            (folder / "report/charts").names() shouldContainExactly listOf("battery.svg")
        }
    }
})
