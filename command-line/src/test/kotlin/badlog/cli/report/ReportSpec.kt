package badlog.cli.report

import badlog.cli.BAG
import badlog.cli.CUT_BAG
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.core.python.HAS_PYTHON
import badlog.exporter.additionsIn
import badlog.files.inFolder
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.readText

@Tags("InCheck")
class ReportSpec : FunSpec({
    val match = SAMPLES.resolve("qualification-42.bag")

    test("the built-in rules find the brownout, as text, CSV and JSON") {
        badlog("report", match, "--no-cache").out shouldContain "browned out at 93.71 s"
        badlog("report", match, "--no-cache", "--csv").out shouldContain ",Browned out,error,"
        val json = badlogJson("report", match, "--no-cache").json.single()
        json.getValue("status").jsonPrimitive.content shouldBe "whole"
        json.getValue("findings").jsonArray.map { it.jsonObject.getValue("rule").jsonPrimitive.content } shouldContain "Browned out"
    }

    test("damaged logs, missing files and other files have a line of JSON each") {
        inFolder { folder ->
            folder.with("logs/a.bag", BAG)
            folder.with("logs/b.bag", CUT_BAG)
            folder.with("logs/photo.gz", ByteArray(100) { 7 })
            val ended = badlogJson("report", folder / "logs", folder / "nix.bag", "--no-cache", "--out", folder / "pages")
            ended.code shouldBe ExitCode.SALVAGED
            ended.json.map { it.getValue("status").jsonPrimitive.content } shouldBe listOf("whole", "salvaged", "skipped", "failed")
            ended.json[0].getValue("output").jsonPrimitive.content shouldBe "${folder / "pages/a.html"}"
            ended.json[0].getValue("notAsked").jsonArray.size shouldBeGreaterThan 1
        }
    }

    test("wrong rules are wrong usage, and rules that can run for no log are left out") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            fun rules(condition: String) = folder.with("r.toml", "[[rule]]\nname='R'\nseverity='note'\nwhen='$condition'\ntext='x'")
            badlog("report", log, "--no-cache", "--rules", rules("Speed <")).code shouldBe ExitCode.USAGE
            badlogJson("report", log, "--no-cache", "--rules", rules("Speed <")).code shouldBe ExitCode.USAGE
            badlog("report", log, "--no-cache", "--csv", "--rules", rules("Speed <")).err shouldContain "The rule “R” is wrong"
            badlog("report", log, "--no-cache", "--rules", rules("Sped < 1")).code shouldBe ExitCode.SALVAGED
            badlog("report", log, "--no-cache", "--rules", rules("Speed < 1")).code shouldBe ExitCode.WHOLE
        }
    }

    test("a report replaces an earlier report, but no other file unless requested") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            repeat(2) { badlog("report", log, "--no-cache", "--out", folder / "pages").code shouldBe ExitCode.WHOLE }
            folder.with("pages/index.html", "mine")
            val refused = badlog("report", log, "--no-cache", "--out", folder / "pages")
            refused.code shouldBe ExitCode.NOTHING
            refused.err shouldContain "--force"
            (folder / "pages/index.html").readText() shouldBe "mine"
            badlog("report", log, "--no-cache", "--out", folder / "pages", "--force").code shouldBe ExitCode.WHOLE
        }
    }

    test("a folder without logs gets no index") {
        inFolder { folder ->
            Files.createDirectories(folder / "none")
            badlog("report", folder / "none", "--no-cache", "--out", folder / "pages").code shouldBe ExitCode.NOTHING
            Files.exists(folder / "pages") shouldBe false
        }
    }

    test("rules may count the time of a CSV file, but not beside pages, which show it as it is") {
        inFolder { folder ->
            val csv = SAMPLES.resolve("elevator-bench.csv")
            val rules = folder.with("r.toml", "[[rule]]\nname='R'\nseverity='note'\nwhen='Time > 1 for 1 s'\ntext='at {time}'")
            badlog("report", csv, "--x", "Time", "--rules", rules, "--no-cache").out shouldContain "1 note in 1 of 1 log"
            badlog("report", csv, "--x", "Time", "--out", folder / "pages").code shouldBe ExitCode.USAGE
        }
    }

    test("rules that cannot be read are distinguished") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            fun said(rules: Path) = badlog("report", log, "--rules", rules).also { it.code shouldBe ExitCode.USAGE }.err
            said(folder / "nix.toml") shouldContain "There is no file"
            said(folder) shouldContain "is a folder"
            said(folder.with("latin.toml", byteArrayOf(0x23, 0xE4.toByte()))) shouldContain "is not UTF-8 text"
        }
    }

    test("pages and an index that links to the findings are in the folder of --out") {
        inFolder { folder ->
            badlog("report", match, "--no-cache", "--out", folder / "pages").code shouldBe ExitCode.WHOLE
            (folder / "pages/index.html").readText() shouldContain "qualification-42.html#t="
            (folder / "pages/qualification-42.html").readText().take(15) shouldBe "<!DOCTYPE html>"
        }
    }

    test("rules that cannot be read, or are empty, are a wrong usage") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            badlog("report", log, "--rules", folder / "nix.toml").code shouldBe ExitCode.USAGE
            val ended = badlog("report", log, "--rules", folder.with("rules.toml", "[[rule]\n"))
            ended.code shouldBe ExitCode.USAGE
            ended.err shouldContain "rules.toml"
        }
    }

    test("findings of hooks are in the table and in the pages").config(enabled = HAS_PYTHON) {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val hook = folder.with("h.py", "print('{\"findings\": [{\"text\": \"odd noise\", \"time\": 0.04}], \"values\": {\"a\": 7}}')")
            val ended = badlog("report", log, "--no-cache", "--hook", "python3 '$hook'", "--out", folder / "pages")
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldContain "0.04 s  warning  odd noise"
            (folder / "pages/index.html").readText() shouldContain "a.html#t=0.04"
            additionsIn(folder / "pages/a.html") shouldContain "odd noise"
        }
    }

    test("a hook that fails is reported, and counts as left out") {
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
