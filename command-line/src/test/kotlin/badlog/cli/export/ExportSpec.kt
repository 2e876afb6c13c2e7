package badlog.cli.export

import badlog.cli.BAG
import badlog.cli.CUT_BAG
import badlog.cli.Ended
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.names
import badlog.cli.with
import badlog.core.python.HAS_PYTHON
import badlog.exporter.additionsIn
import badlog.files.inFolder
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.jsonPrimitive
import java.awt.image.BufferedImage
import java.nio.file.Files
import javax.imageio.ImageIO
import kotlin.io.path.div
import kotlin.io.path.readText

@Tags("InCheck")
class ExportSpec : FunSpec({
    test("a page is beside its log, or below the folder for all") {
        inFolder { folder ->
            folder.with("logs/a.bag", BAG)
            folder.with("logs/deep/b.bag", CUT_BAG)
            badlog("export", folder / "logs/a.bag").code shouldBe ExitCode.WHOLE
            (folder / "logs/a.bag.html").readText().take(15) shouldBe "<!DOCTYPE html>"
            val ended = badlog("export", folder / "logs", "-o", folder / "pages")
            ended.code shouldBe ExitCode.SALVAGED
            ended.out shouldContain "error    line 7"
            (folder / "pages").names() shouldContainExactly listOf("a.bag.html", "deep")
        }
    }

    test("--out is the page of a single log if it has an ending, otherwise a folder, as it is for convert and for badlog-html") {
        inFolder { folder ->
            val log = folder.with("big.bag", BAG)
            badlog("export", log, "--out", folder / "big.html").code shouldBe ExitCode.WHOLE
            badlog("export", log, "--out", folder / "bigout").code shouldBe ExitCode.WHOLE
            (folder / "bigout").names() shouldContainExactly listOf("big.bag.html")
            badlog("convert", log, "--to", "csv", "--out", folder / "tables").code shouldBe ExitCode.WHOLE
            (folder / "tables").names() shouldContainExactly listOf("big.csv")
            badlog("convert", log, "--out", folder / "big.csv").code shouldBe ExitCode.WHOLE
            (folder / "big.csv").readText() shouldBe (folder / "tables/big.csv").readText()
        }
    }

    test("a log with the longest possible name gets a page") {
        inFolder { folder ->
            val log = folder.with("n".repeat(251) + ".bag", BAG)
            badlog("export", log).code shouldBe ExitCode.WHOLE
            folder.names().count { it.startsWith("nnn") && it.endsWith(".html") } shouldBe 1
        }
    }

    test("attachments are in the page, and a missing one stops before any work") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val notes = folder.with("notes.txt", "hello")
            badlog("export", log, "-a", notes).code shouldBe ExitCode.WHOLE
            (folder / "a.bag.html").readText() shouldContain "notes.txt"
            badlog("export", log, "-a", folder / "nix.txt", "--force").code shouldBe ExitCode.NOTHING
        }
    }

    test("a page names the video that lies beside it or below, and may play that alone") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val video = folder.with("video/match 1.mp4", "a video")
            badlog("export", log, "--video", video).code shouldBe ExitCode.WHOLE
            additionsIn(folder / "a.bag.html") shouldContain "\"video\":\"video/match 1.mp4\""
            (folder / "a.bag.html").readText() shouldContain "media-src blob: 'self';"
            badlog("export", log, "--force").code shouldBe ExitCode.WHOLE
            (folder / "a.bag.html").readText() shouldContain "media-src blob:;"
        }
    }

    test("a video that is missing, elsewhere or for several logs is refused with the reason") {
        inFolder { folder ->
            val log = folder.with("logs/a.bag", BAG)
            val video = folder.with("match.mp4", "a video")
            badlog("export", log, "--video", folder / "nix.mp4").code shouldBe ExitCode.NOTHING
            badlog("export", log, "--video", video).run {
                code shouldBe ExitCode.NOTHING
                err shouldContain "is not in the folder of"
            }
            badlog("export", folder / "logs", "--video", video).run {
                code shouldBe ExitCode.USAGE
                err shouldContain "name only its log"
            }
            badlog("export", log, "--video", video, "--out", folder / "a.html").code shouldBe ExitCode.WHOLE
        }
    }

    test("a page has the topics to calculate, and impossible ones are reported") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val ended = badlog("export", log, "--topic", "Twice = Speed * 2", "--topic", "Odd = Sped * 2")
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldContain "“Sped” is not a topic"
            additionsIn(folder / "a.bag.html") shouldContain "Twice = Speed * 2"
        }
    }

    test("a page has the named rules, otherwise the rules beside the log, otherwise the built-in ones, and none on request") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val builtIn = "The roboRIO browned out"
            fun export(vararg options: Any): String {
                badlog("export", log, "--force", *options).code shouldBe ExitCode.WHOLE
                return additionsIn(folder / "a.bag.html")
            }
            export() shouldContain builtIn
            export("--no-rules") shouldNotContain builtIn
            val named = folder.with("r.toml", "[[rule]]\nname='Fast'\nseverity='note'\nwhen='Speed > 5'\ntext='It was fast.'")
            export("--rules", named) shouldContain "It was fast."
            val beside = folder.with("badlog-rules.toml", "[[rule]]\nname='Fast'\nseverity='note'\nwhen='Speed > 5'\ntext='Very fast.'")
            export() shouldContain "Very fast."
            export("--rules", "default") shouldContain builtIn
            val json = badlogJson("export", log, "--force").json.single()
            json.getValue("rulesFile").jsonPrimitive.content shouldBe "$beside"
            badlog("export", log, "--rules", folder / "nix.toml", "--force").code shouldBe ExitCode.USAGE
            badlog("export", log, "--rules", named, "--no-rules", "--force").code shouldBe ExitCode.USAGE
        }
    }

    test("a mistake in the rules beside a log is reported, and its page has the built-in ones") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            folder.with("badlog-rules.toml", "[[rule]]\nname='Fast'\nseverity='bad'\nwhen='Speed > 5'\ntext='t'")
            val ended = badlog("export", log)
            ended.code shouldBe ExitCode.SALVAGED
            ended.err shouldContain "badlog-rules.toml: Line 3: A severity is"
            additionsIn(folder / "a.bag.html") shouldContain "The roboRIO browned out"
        }
    }

    test("a page begins with the layout beside its log; a mistake in it is reported, and the page is made without it") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            folder.with("default.badlog-layout.json", """{"badlog-layout":1,"graphs":[{"title":"Ours","lines":["Speed"]}]}""")
            badlog("export", log).code shouldBe ExitCode.WHOLE
            additionsIn(folder / "a.bag.html") shouldContain "Ours"
            badlog("report", log, "--out", folder / "report", "--no-cache").code shouldBe ExitCode.WHOLE
            additionsIn(folder / "report/a.html") shouldContain "Ours"
            folder.with("default.badlog-layout.json", """{"badlog-layout":1,"graphs":[{"title":"Ours"}]}""")
            for (ended in listOf(badlog("export", log, "--force"), badlog("report", log, "--out", folder / "report", "--no-cache"))) {
                ended.code shouldBe ExitCode.SALVAGED
                ended.err shouldContain "default.badlog-layout.json is not used: The graphs are damaged: graph 1 has no list of “lines”"
            }
            additionsIn(folder / "a.bag.html") shouldNotContain "Ours"
        }
    }

    test("a page carries the field beside its log, or the one that was named, with its picture, and says how large that is") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val corners = "\"field-corners\":{\"top-left\":[0,0],\"bottom-right\":[4,2]}"
            val text = """{"field-image":"f.png",$corners,"field-size":[54,27],"field-unit":"foot"}"""
            val field = folder.with("field.json", text)
            ImageIO.write(BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB), "png", (folder / "f.png").toFile())
            val ended = badlog("export", log)
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldContain "with the picture of a field, 0 kB"
            additionsIn(folder / "a.bag.html") shouldContain "data:image/png;base64,"
            val named = folder.with("other.json", text.replace("f.png", "gone.png"))
            badlog("export", log, "--force", "--field", named).run {
                code shouldBe ExitCode.USAGE
                err shouldContain "other.json is not used: Its picture “gone.png” cannot be read; put it beside the file."
            }
            badlog("export", log, "--force", "--field", field).code shouldBe ExitCode.WHOLE
            badlog("report", log, "--out", folder / "report", "--no-cache").code shouldBe ExitCode.WHOLE
            additionsIn(folder / "report/a.html") shouldContain "data:image/png;base64,"
            folder.with("field.json", "{}")
            val damaged = badlog("export", log, "--force")
            damaged.code shouldBe ExitCode.SALVAGED
            damaged.err shouldContain "field.json is not used: "
            additionsIn(folder / "a.bag.html") shouldNotContain "data:image"
            val report = badlog("report", log, "--out", folder / "report", "--no-cache")
            report.code shouldBe ExitCode.SALVAGED
            report.err shouldContain "field.json is not used: "
            additionsIn(folder / "report/a.html") shouldNotContain "data:image"
            val mine = folder.with("mine.json", text)
            badlog("report", log, "--out", folder / "report", "--no-cache", "--field", mine).code shouldBe ExitCode.WHOLE
            additionsIn(folder / "report/a.html") shouldContain "data:image/png;base64,"
            badlog("report", log, "--out", folder / "none", "--no-cache", "--field", named).run {
                code shouldBe ExitCode.USAGE
                err shouldContain "other.json is not used: Its picture “gone.png” cannot be read; put it beside the file."
            }
            Files.exists(folder / "none") shouldBe false
            badlog("report", log, "--field", mine).run {
                code shouldBe ExitCode.USAGE
                err shouldContain "--field needs --out"
            }
        }
    }

    test("the hooks of rules that lie beside a log are never run") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            folder.with("badlog-rules.toml", "[[hook]]\ncommand = 'touch ${folder / "ran"}'\n")
            badlog("export", log).code shouldBe ExitCode.WHOLE
            folder.names().contains("ran") shouldBe false
        }
    }

    test("wrong rules, and rules with topics that the log lacks, are reported") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            fun export(condition: String): Ended {
                val rules = folder.with("r.toml", "[[rule]]\nname='R'\nseverity='note'\nwhen='$condition'\ntext='x'")
                return badlog("export", log, "--force", "--rules", rules)
            }
            val wrong = export("Speed <")
            wrong.code shouldBe ExitCode.USAGE
            wrong.out shouldContain "The rule “R” is wrong"
            val missing = export("Sped < 1")
            missing.code shouldBe ExitCode.SALVAGED
            missing.out shouldContain "“Sped” is not a topic"
            export("Speed < 1").code shouldBe ExitCode.WHOLE
        }
    }

    test("a page has the results of hooks, of the command line and of the rules").config(enabled = HAS_PYTHON) {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            folder.with("two.py", "print('{\"findings\": [{\"text\": \"found by two\"}]}')")
            val rules = folder.with("r.toml", "[[hook]]\ncommand = 'python3 two.py'\n")
            val one = folder.with("one.py", "print('{\"values\": {\"lowest\": \"found by one\"}}')")
            val ended = badlog("export", log, "--rules", rules, "--hook", "python3 '$one'")
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldContain "1 finding"
            additionsIn(folder / "a.bag.html") shouldContain "found by one"
            additionsIn(folder / "a.bag.html") shouldContain "found by two"
        }
    }

    test("a hook that cannot be started leaves out only its part, and wrong options are wrong usage") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val ended = badlog("export", log, "--hook", "no-such-program")
            ended.code shouldBe ExitCode.SALVAGED
            ended.out shouldContain "cannot be started"
            (folder / "a.bag.html").readText().take(15) shouldBe "<!DOCTYPE html>"
            badlog("export", log, "--hook", "a 'b").code shouldBe ExitCode.USAGE
            badlog("export", log, "--hook", "a", "--hook-seconds", "0").code shouldBe ExitCode.USAGE
        }
    }
})
