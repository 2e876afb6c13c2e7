package badlog.cli.report

import badlog.cli.BAG
import badlog.cli.ExitCode
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.inFolder
import badlog.cli.with
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.io.path.div
import kotlin.io.path.readText
import kotlinx.serialization.json.Json

class ReportSpec : FunSpec({
    val match = SAMPLES.resolve("qualification-42.bag")

    test("the rules that badlog brings along find the brownout, as text, CSV and JSON") {
        badlog("report", match, "--no-cache").out shouldContain "browned out at 93.7096 s"
        badlog("report", match, "--no-cache", "--csv").out shouldContain ",Browned out,error,"
        Json.parseToJsonElement(badlog("report", match, "--no-cache", "--json").out)
    }

    test("pages and an index that links to the findings stand in the folder asked for") {
        inFolder { folder ->
            badlog("report", match, "--no-cache", "--out", folder / "pages").code shouldBe ExitCode.WHOLE
            (folder / "pages/index.html").readText() shouldContain "qualification-42.html#t="
            (folder / "pages/qualification-42.html").readText().take(15) shouldBe "<!DOCTYPE html>"
        }
    }

    test("rules that cannot be read, or say nothing, are a wrong usage") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            badlog("report", log, "--rules", folder / "nix.toml").code shouldBe ExitCode.USAGE
            val ended = badlog("report", log, "--rules", folder.with("rules.toml", "[[rule]\n"))
            ended.code shouldBe ExitCode.USAGE
            ended.err shouldContain "rules.toml"
        }
    }
})
