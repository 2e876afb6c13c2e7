package badlog.exporter.program

import badlog.exporter.BADLOG_VERSION
import badlog.exporter.BAG
import badlog.exporter.CUT_BAG
import badlog.exporter.HtmlExporter
import badlog.exporter.ReadPage
import badlog.exporter.additionsIn
import badlog.exporter.names
import badlog.files.gzip
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.awt.image.BufferedImage
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.file.attribute.FileTime
import javax.imageio.ImageIO
import kotlin.io.path.createDirectory
import kotlin.io.path.div
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.setLastModifiedTime
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

class BadlogHtmlSpec : FunSpec({
    test("the page of one input is beside it, and its path is printed on the standard output") {
        inFolder { folder ->
            val ended = run(folder.with("match.bag"))
            ended.code shouldBe ExitCode.WHOLE
            ended.lines shouldContainExactly listOf("${folder / "match.bag.html"}")
            ended.err shouldBe ""
            ReadPage(folder / "match.bag.html").inflated().decodeToString() shouldBe BAG
        }
    }

    test("input and output are accepted as by the original, with all of its flags") {
        inFolder { folder ->
            val notes = folder.with("notes.txt", "hello")
            val ended = run("-tcg", "-o", "-a", notes, folder.with("match.bag"), folder / "page")
            ended.code shouldBe ExitCode.WHOLE
            ended.opened shouldContainExactly listOf(folder / "page")
            ReadPage(folder / "page").attachments.getValue("notes.txt").decodeToString() shouldBe "hello"
            run("--trim-doubles", "--csv", "--gzip", folder / "match.bag").code shouldBe ExitCode.WHOLE
        }
    }

    test("several files follow -a, as in the original, but no log, no page and no folder") {
        inFolder { folder ->
            val (one, two) = folder.with("a.txt", "one") to folder.with("b.txt", "two")
            val log = folder.with("match.bag")
            val ways = listOf(
                listOf("-a", one, two, log),
                listOf(log, "--attach", one, two),
                listOf("-a", one, "-a", two, log),
                listOf(log, "--attach=$one", two),
                listOf("-t", "-a$one", two, log),
                listOf("-ta", one, two, log),
            )
            for (arguments in ways) {
                val ended = run(*arguments.toTypedArray(), "--out", folder / "out/page.html")
                ended.code shouldBe ExitCode.WHOLE
                ended.lines shouldContainExactly listOf("${folder / "out/page.html"}")
                ReadPage(folder / "out/page.html").attachments.mapValues { it.value.decodeToString() } shouldBe mapOf("a.txt" to "one", "b.txt" to "two")
            }
            run("-a", one, log, folder / "out/page.html").code shouldBe ExitCode.WHOLE
            ReadPage(folder / "out/page.html").attachments.keys shouldBe setOf("a.txt")
            run("-a", one, two).code shouldBe ExitCode.USAGE
            // A log is one by its content, whatever its name.
            for (name in listOf("match", "match.txt", "match.dat")) {
                val other = folder.with(name)
                run("-a", one, other, "--out", folder / "$name.html").code shouldBe ExitCode.WHOLE
                ReadPage(folder / "$name.html").attachments.keys shouldBe setOf("a.txt")
            }
        }
    }

    test("with --compare, each page has the other log's bytes, but not its own a second time") {
        inFolder { folder ->
            val other = folder.with("best.bag", "Time,A\n0,1\n")
            run("--compare", other, folder.with("match.bag"), "--out", folder / "match.html").code shouldBe ExitCode.WHOLE
            ReadPage(folder / "match.html").compared.mapValues { it.value.decodeToString() } shouldBe mapOf("best.bag" to "Time,A\n0,1\n")
            run("--compare", other, folder, "--out", folder / "pages").code shouldBe ExitCode.WHOLE
            ReadPage(folder / "pages/best.bag.html").compared shouldBe emptyMap()
            val refused = run("--compare", (folder / "pit.jpg").apply { writeBytes(byteArrayOf(-1, -40, -1, 0, 0, 16)) }, folder / "match.bag")
            refused.code shouldBe ExitCode.NOTHING
            refused.err shouldContain "pit.jpg"
            run("--compare", folder / "none.bag", folder / "match.bag").err shouldContain "none.bag"
        }
    }

    test("a page begins with the layout beside its log, by type of match; a mistake in it is reported once, and every page is made") {
        inFolder { folder ->
            val layouts = ArrayList<String?>()
            val export: Export = { input, page, additions, progress ->
                layouts += additions.layout
                HtmlExporter().export(input, page, additions, progress)
            }
            fun made(): String {
                val err = ByteArrayOutputStream()
                BadlogHtml(PrintStream(ByteArrayOutputStream()), PrintStream(err), false, { _, _ -> export }) { true }.run(listOf("$folder"))
                return err.toString()
            }
            folder.with("a.bag")
            folder.with("b.bag", BAG.replace("\"values\":[", "\"values\":[{\"name\":\"Match Type\",\"value\":\"Practice\"},"))
            val all = (folder / "default.badlog-layout.json").apply { writeText("""{"badlog-layout":1,"graphs":[]}""") }
            val practice = (folder / "practice.badlog-layout.json").apply { writeText("""{"badlog-layout":1,"formulas":[]}""") }
            made() shouldBe ""
            layouts shouldContainExactly listOf(all.readText(), practice.readText())
            all.writeText("""{"badlog-layout":1,"graphs":[7]}""")
            practice.writeText("no")
            layouts.clear()
            val said = made().lines().filter { it.isNotEmpty() }
            said shouldContainExactly listOf(
                "The layout $all is not used: The graphs are damaged: graph 1 is not an object (line 1, column 30); select a file that badlog has saved.",
                "The layout $practice is not used: It is not a layout, or is damaged in line 1, column 1; select a file that badlog has saved.",
            )
            layouts shouldContainExactly listOf(null, null)
        }
    }

    test("a page has the named field, otherwise the one beside its log; a mistake in the named one stops before any work") {
        inFolder { folder ->
            val log = folder.with("a.bag")
            val field = """{"field-image":"f.png","field-corners":{"top-left":[0,0],"bottom-right":[4,2]},"field-size":[54,27],"field-unit":"foot"}"""
            val named = folder.with("other.json", field)
            run(log, "--field", named).run {
                code shouldBe ExitCode.USAGE
                err shouldContain "other.json is not used: Its picture “f.png” cannot be read"
            }
            folder.names() shouldContainExactly listOf("a.bag", "other.json")
            ImageIO.write(BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB), "png", (folder / "f.png").toFile())
            run(log, "--field", named).code shouldBe ExitCode.WHOLE
            additionsIn(folder / "a.bag.html") shouldContain "data:image/png;base64,"
            run(log).code shouldBe ExitCode.WHOLE
            additionsIn(folder / "a.bag.html") shouldNotContain "data:image"
            folder.with("field.json", field)
            run(log).code shouldBe ExitCode.WHOLE
            additionsIn(folder / "a.bag.html") shouldContain "data:image/png;base64,"
        }
    }

    test("a page names the video in or below its folder, and may play only that; any other video is refused with the reason") {
        inFolder { folder ->
            val log = folder.with("a.bag")
            val video = (folder / "video").createDirectory().with("match 1.mp4", "a video")
            run(log, "--video", video).code shouldBe ExitCode.WHOLE
            additionsIn(folder / "a.bag.html") shouldContain "\"video\":\"video/match 1.mp4\""
            (folder / "a.bag.html").readText() shouldContain "media-src blob: 'self';"
            run(log, "--video", folder / "nix.mp4").run {
                code shouldBe ExitCode.NOTHING
                err shouldContain "There is no file"
            }
            run(log, "--video", video, "--out", folder / "pages").run {
                code shouldBe ExitCode.NOTHING
                err shouldContain "$video is not in the folder of ${folder / "pages" / "a.bag.html"}; move it there"
            }
            run(log, folder.with("b.bag"), "--video", video).run {
                code shouldBe ExitCode.USAGE
                err shouldContain "name only its log"
            }
        }
    }

    test("a salvaged log has a page, and exit code 3") {
        inFolder { folder ->
            val ended = run(folder.with("cut.bag", CUT_BAG), folder.with("whole.bag"))
            ended.code shouldBe ExitCode.SALVAGED
            ended.lines.size shouldBe 2
            ended.err shouldContain "${folder / "cut.bag"}: salvaged. "
            ended.err.lines().size shouldBe 2
        }
    }

    test("a missing input has exit code 3 if another page was made, otherwise 1") {
        inFolder { folder ->
            val missing = folder / "nix.bag"
            run(folder.with("a.bag"), missing, folder / "a.bag").code shouldBe ExitCode.SALVAGED
            val ended = run(missing)
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldBe "There is no file or folder $missing; check the spelling.\n"
            folder.names() shouldContainExactly listOf("a.bag", "a.bag.html")
        }
    }

    test("a file of nonsense is reported if it was named, and has no page") {
        inFolder { folder ->
            (folder / "x.bag").writeBytes(byteArrayOf(1, 2, 3))
            val ended = run(folder / "x.bag")
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain "${folder / "x.bag"}: This file is not a log"
            val found = run(folder)
            found.code shouldBe ExitCode.NOTHING
            found.err shouldContain "No logs found."
            folder.names() shouldContainExactly listOf("x.bag")
        }
    }

    test("a bug in badlog costs one file its page, and is reported in one line") {
        inFolder { folder ->
            for (name in listOf("a.bag", "b.bag", "c.bag")) folder.with(name)
            val ended = run(folder, failsOn = "b.bag")
            ended.code shouldBe ExitCode.SALVAGED
            ended.lines shouldContainExactly listOf("a", "c").map { "${folder / "$it.bag.html"}" }
            ended.err shouldContain "${folder / "b.bag"}: This is a bug in badlog ("
            ended.err.lines().size shouldBe 2
            run(folder / "b.bag", failsOn = "b.bag").code shouldBe ExitCode.NOTHING
        }
    }

    test("a missing attachment stops before any work") {
        inFolder { folder ->
            val ended = run("-a", folder / "nix.txt", folder.with("a.bag"), folder.with("b.bag"))
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain "There is no file or folder ${folder / "nix.txt"}"
            ended.err.lines().size shouldBe 2
        }
    }

    test("the newest input's page is opened, and a missing browser is not a failure") {
        inFolder { folder ->
            folder.with("old.bag").setLastModifiedTime(FileTime.fromMillis(1_000_000))
            folder.with("new.bag").setLastModifiedTime(FileTime.fromMillis(3_000_000))
            folder.with("z.bag").setLastModifiedTime(FileTime.fromMillis(2_000_000))
            val ended = run("--open", folder, canOpen = false)
            ended.code shouldBe ExitCode.WHOLE
            ended.opened shouldContainExactly listOf(folder / "new.bag.html")
            ended.err shouldContain "open ${folder / "new.bag.html"} yourself"
        }
    }

    test("wrong usage is reported with exit code 2") {
        run().code shouldBe ExitCode.USAGE
        run("--nix", "a").err shouldContain "--nix"
        run("a", "--out").code shouldBe ExitCode.USAGE
        run("--nix", "a").err shouldContain "badlog-html --help"
    }

    test("help and version have exit code 0") {
        val help = run("--help")
        help.code shouldBe ExitCode.WHOLE
        val text = help.lines.joinToString("\n")
        for (part in listOf("-t, --trim", "-c, --csv", "-g, --gzip", "-a, --attach", "-o, --open", "--out", "--field", "--video", "3 some")) {
            text shouldContain part
        }
        run("--version").lines shouldContainExactly listOf("badlog-html $BADLOG_VERSION")
    }

    test("a file whose name begins with @ or - is a file") {
        inFolder { folder -> run("--", folder.with("@a.bag")).code shouldBe ExitCode.WHOLE }
    }

    test("a page has the rules of the packs beside its log, and an unusable pack is reported") {
        inFolder { folder ->
            val log = folder.with("a.bag")
            (folder / "ours.badlog-rules").createDirectory()
            folder.with("ours.badlog-rules/badlog-rules.toml", "[[rule]]\nname='Ours'\nseverity='note'\nwhen='Speed > 5'\ntext='Ours was found.'\n")
            run(log).code shouldBe ExitCode.WHOLE
            additionsIn(folder / "a.bag.html") shouldContain "Ours was found."
            folder.with("theirs.badlog-rules.zip", "not a zip")
            val ended = run(log)
            ended.code shouldBe ExitCode.SALVAGED
            ended.err shouldContain "theirs.badlog-rules.zip is not a zip that can be read"
            additionsIn(folder / "a.bag.html") shouldContain "Ours was found."
        }
    }
})
