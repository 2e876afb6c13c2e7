package badlog.cli.report

import badlog.cli.BAG
import badlog.cli.ExitCode
import badlog.cli.HAS_PYTHON
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

    test("what hooks find is in the table and in the pages").config(enabled = HAS_PYTHON) {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val hook = folder.with("h.py", "print('{\"findings\": [{\"text\": \"odd noise\", \"time\": 0.04}], \"values\": {\"a\": 7}}')")
            val ended = badlog("report", log, "--no-cache", "--hook", "python3 '$hook'", "--out", folder / "pages")
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldContain "0.04 s  warning  odd noise"
            (folder / "pages/index.html").readText() shouldContain "a.html#t=0.04"
            (folder / "pages/a.html").readText() shouldContain "odd noise"
        }
    }

    test("a hook that fails is told, and counts as left out") {
        inFolder { folder ->
            val ended = badlog("report", folder.with("a.bag", BAG), "--no-cache", "--hook", "no-such-program")
            ended.code shouldBe ExitCode.SALVAGED
            ended.out shouldContain "a.bag, hook “no-such-program”:"
        }
    }

    test("rules may use topics that are calculated") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val rules = folder.with("r.toml", "[[rule]]\nname='F'\nseverity='note'\nwhen='max(Twice) > 10'\ntext='{value}'")
            badlog("report", log, "--no-cache", "--rules", rules, "--topic", "Twice [m/s] = Speed * 2").out shouldContain "11 m/s"
        }
    }
})
