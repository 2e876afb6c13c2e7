package badlog.exporter.program

import badlog.exporter.BAG
import badlog.exporter.ReadPage
import badlog.exporter.names
import badlog.files.gzip
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlin.io.path.createDirectories
import kotlin.io.path.createDirectory
import kotlin.io.path.div
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeBytes

/** The places of pages, and the files that have pages. */
class PagePlacesSpec : FunSpec({
    test("a path with a page's ending is the output, whether it exists or not") {
        inFolder { folder ->
            folder.with("a.bag")
            for (name in listOf("p.html", "p.htm", "P.HTM")) {
                folder.with("old$name", "old")
                for (page in listOf(folder / name, folder / name, folder / "old$name")) {
                    run(folder / "a.bag", page).lines shouldContainExactly listOf("$page")
                    ReadPage(page).inflated().decodeToString() shouldBe BAG
                }
            }
        }
    }

    test("a second run replaces an output without such an ending") {
        inFolder { folder ->
            folder.with("a.bag")
            repeat(2) { run(folder / "a.bag", folder / "page").lines shouldContainExactly listOf("${folder / "page"}") }
            folder.names() shouldContainExactly listOf("a.bag", "page")
        }
    }

    test("any other second path is an input, and an existing file stays unchanged") {
        inFolder { folder ->
            folder.with("a.bag")
            for (name in listOf("b.bag", "b", "b.csv")) {
                run(folder / "a.bag", folder.with(name)).lines.size shouldBe 2
                (folder / name).readText() shouldBe BAG
            }
        }
    }

    test("a mistyped log is reported as missing, and is not taken for the output") {
        inFolder { folder ->
            folder.with("a.bag")
            for (name in listOf("nix.bag", "nix.badbag", "nix.CSV", "nix.bag.gz", "nix.wpilog")) {
                repeat(2) {
                    val ended = run(folder / "a.bag", folder / name)
                    ended.code shouldBe ExitCode.SALVAGED
                    ended.err shouldContain "There is no file or folder ${folder / name}"
                }
            }
            folder.names() shouldContainExactly listOf("a.bag", "a.bag.html")
        }
    }

    test("a folder has a page of every log directly in it, whatever its name, and of nothing else") {
        inFolder { folder ->
            for (name in listOf("b.bag", "A", "log.bag1519", "c.csv", ".hidden", "page.html", "README.md", "build.gradle")) folder.with(name)
            (folder / "z.gz").writeBytes(gzip(BAG.encodeToByteArray()))
            (folder / "video.mp4").writeBytes(byteArrayOf(0, 0, 0, 32, 1, 2))
            (folder / "sub").createDirectory().with("deep.bag")
            val ended = run(folder, "--out", folder / "out")
            ended.code shouldBe ExitCode.WHOLE
            (folder / "out").names() shouldContainExactly
                listOf("A.html", "b.bag.html", "c.csv.html", "log.bag1519.html", "z.gz.html")
            ended.err shouldBe "1 file is not a log and was skipped.\n"
        }
    }

    test("--out is the page of a single log if it has an ending, otherwise a folder, as for several logs") {
        inFolder { folder ->
            val log = folder.with("big.bag")
            run(log, "--out", folder / "big.html").lines shouldContainExactly listOf("${folder / "big.html"}")
            run(log, "--out", folder / "bigout").lines shouldContainExactly listOf("${folder / "bigout/big.bag.html"}")
            run(log, folder.with("small.bag"), "--out", folder / "all.html").lines.size shouldBe 2
            (folder / "all.html").names() shouldContainExactly listOf("big.bag.html", "small.bag.html")
        }
    }

    test("pages of equal names in one folder get different names") {
        inFolder { folder ->
            val second = (folder / "second").createDirectory().with("a.bag")
            val third = (folder / "third").createDirectory().with("A.bag")
            val first = folder.with("a.bag")
            run(first, folder.with("a.bag.gz"), second, third, first, "--out=${folder / "out"}").lines.size shouldBe 4
            (folder / "out").names() shouldContainExactlyInAnyOrder
                listOf("a.bag.html", "a.bag.gz.html", "a.bag (2).html", "A.bag (3).html")
        }
    }

    test("no page replaces an input") {
        inFolder { folder ->
            run(folder.with("a"), folder.with("a.html"), folder.with("b")).code shouldBe ExitCode.WHOLE
            (folder / "a.html").readText() shouldBe BAG
            folder.names() shouldContain "a (2).html"
            run(folder / "b", folder / "b").lines shouldContainExactly listOf("${folder / "b.html"}")
        }
    }

    test("a file as the output folder of several pages is reported") {
        inFolder { folder ->
            val ended = run(folder.with("a.bag"), folder.with("b.bag"), "--out", folder.with("file"))
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain "${folder / "file"} is a file, not a folder"
        }
    }

    test("--empty makes badlog.html in the folder of the pages, or alone, and never in place of a folder") {
        inFolder { folder ->
            val both = run("--empty", "--out", "$folder/pages/", folder.with("match.bag"))
            both.code shouldBe ExitCode.WHOLE
            both.lines shouldContainExactly listOf("${folder / "pages" / "badlog.html"}", "${folder / "pages" / "match.bag.html"}")
            val page = (folder / "pages" / "badlog.html").readText()
            page shouldContain "<title>badlog</title>"
            page shouldContain "id=\"sample\" data-name=\"brownout.bag\""
            page shouldNotContain "id=\"recording\""
            run("--empty", "--out", "$folder/alone/").lines shouldContainExactly listOf("${folder / "alone" / "badlog.html"}")
            (folder / "taken" / "badlog.html").createDirectories()
            val refused = run("--empty", "--out", "$folder/taken/")
            refused.code shouldBe ExitCode.NOTHING
            refused.err shouldContain "is a folder"
            run("--out", "$folder/alone/").code shouldBe ExitCode.USAGE
        }
    }
})
