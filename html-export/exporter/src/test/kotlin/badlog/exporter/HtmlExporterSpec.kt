package badlog.exporter

import badlog.core.json.quotedJson
import badlog.core.recording.ProblemKind
import badlog.files.gzip
import badlog.files.inFolder
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.jsonPrimitive
import java.io.IOException
import java.nio.channels.ClosedByInterruptException
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.deleteExisting
import kotlin.io.path.div
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

class HtmlExporterSpec : FunSpec({
    val parts = PageParts("draw()", "main{}", "p{}")
    val exporter = HtmlExporter(parts = parts)

    // The two files of a Driver Station log.
    val head = byteArrayOf(0, 0, 0, 4, 0, 0, 0, 0, -27, -47, 3, 5, 0, 0, 0, 0, 0, 0, 0, 0)
    val record = byteArrayOf(10, 0, 12, 0, 80, 0xDB.toByte(), 60, 0, 0, 0, 0, 0, 0, 0)
    val said = "FMS Event Name: MILLC FMS Connected:   Qualification - 42:1, Field Time: 26/3/7 10:4:5".encodeToByteArray()
    val first = head + record + record
    val second = head + head.copyOfRange(4, 20) + byteArrayOf(0, 0, 0, said.size.toByte()) + said

    fun pageOf(bytes: ByteArray, name: String = "match.bag", check: (ReadPage, ExportReport) -> Unit) = inFolder { folder ->
        val input = folder / name
        input.writeBytes(bytes)
        val report = exporter.export(input, folder / "page.html")
        folder.names() shouldContainExactly listOf(name, "page.html").sorted()
        check(ReadPage(folder / "page.html"), report)
    }

    test("a page has the bytes of its bag, and the name of its match") {
        pageOf(BAG.encodeToByteArray()) { page, report ->
            page.inflated().decodeToString() shouldBe BAG
            page.title shouldBe "OHCL Match 42"
            page.about.getValue("name").jsonPrimitive.content shouldBe "match.bag"
            page.about.getValue("original").jsonPrimitive.content shouldBe "raw"
            page.about.getValue("inflatedBytes").jsonPrimitive.content shouldBe "${BAG.length}"
            page.about.getValue("version").jsonPrimitive.content shouldBe BADLOG_VERSION
            page.about["cut"].shouldBeNull()
            page.program shouldBe "draw()"
            page.style shouldBe "main{}"
            page.waitingStyle shouldBe "p{}"
            page.policy shouldBe parts.policy(false)
            report.recording.rowCount shouldBe 2
            report.recording.isSalvaged shouldBe false
            report.originalBytes shouldBe BAG.length
        }
    }

    test("the title of a page without match values is the match in the file's name, otherwise that name") {
        pageOf("a,b\n1,2\n".encodeToByteArray(), "Q42.csv") { page, _ -> page.title shouldBe "Qualification 42" }
        pageOf("a,b\n1,2\n".encodeToByteArray(), "practice run") { page, _ -> page.title shouldBe "practice run" }
    }

    test("an empty file has a page, which reports that") {
        pageOf(ByteArray(0)) { page, report ->
            page.inflated().size shouldBe 0
            report.recording.isSalvaged shouldBe true
        }
    }

    test("gzip is embedded unchanged, and read") {
        val gzip = gzip(BAG.encodeToByteArray())
        pageOf(gzip) { page, report ->
            page.recording shouldBe gzip
            page.title shouldBe "OHCL Match 42"
            page.about.getValue("original").jsonPrimitive.content shouldBe "gzip"
            page.about.getValue("inflatedBytes").jsonPrimitive.content shouldBe "${BAG.length}"
            page.about["cut"].shouldBeNull()
            report.recording.isSalvaged shouldBe false
            report.originalBytes shouldBe gzip.size
        }
        pageOf(gzip.copyOf(gzip.size - 8)) { page, report ->
            page.about["cut"].shouldBeNull()
            report.recording.isSalvaged shouldBe false
        }
        pageOf(gzip + gzip("0.0400,3.0000\n".encodeToByteArray())) { _, report -> report.recording.rowCount shouldBe 3 }
    }

    test("a long text with numbers further down is a recording, as for the parser") {
        val text = ("Note\n" + "ready\n".repeat(50_000) + "1.5\n".repeat(60_000)).encodeToByteArray()
        check(text.size - 4 * 60_000 > FileHead.BYTES)
        for (bytes in listOf(text, gzip(text))) {
            pageOf(bytes) { page, report ->
                page.inflated() shouldBe text
                report.recording.rowCount shouldBe 110_000
            }
        }
    }

    test("cut gzip is reported, and its readable part is kept") {
        val rows = BAG + (2..5000).joinToString("") { "0.0$it,${it * 7919 % 1000}.0\n" }
        val gzip = gzip(rows.encodeToByteArray())
        pageOf(gzip.copyOf(gzip.size / 2)) { page, report ->
            page.recording.size shouldBe gzip.size / 2
            page.about.getValue("cut").jsonPrimitive.content shouldBe "true"
            page.about.getValue("inflatedBytes").jsonPrimitive.content shouldBe "${report.inflatedBytes}"
            report.recording.problems.first().kind shouldBe ProblemKind.GZIP_CUT
            report.recording.isSalvaged shouldBe true
            check(report.recording.rowCount in 1000..4999)
        }
    }

    test("hostile names and values cannot end their elements") {
        val evil = "</script><script>alert(1)</script><!--<img src=x onerror=alert(1)>\"'&amp;\u0001"
        val header = "{\"topics\":[],\"values\":[{\"name\":\"Event\",\"value\":${quotedJson("</title>$evil")}}]}\nA\n1\n"
        inFolder { folder ->
            val name = "<!--'\"&<\\script>\u0001ü"
            val input = folder / name
            input.writeText(header)
            HtmlExporter(listOf(input), parts = parts).export(input, folder / "page.html")
            val page = ReadPage(folder / "page.html")
            page.about.getValue("name").jsonPrimitive.content shouldBe name
            page.title shouldContain "&lt;/title&gt;&lt;/script&gt;"
            page.attachments.getValue("&lt;!--'&quot;&amp;&lt;\\script&gt;\u0001ü").decodeToString() shouldBe header
            page.count("script") shouldBe 5
            page.count("img") shouldBe 0
            page.html shouldNotContain "<!--"
        }
    }

    test("a log of two files is whole in the page, with the start of the second file, which determines the title") {
        inFolder { folder ->
            val log = folder / "2026_03_07 10_04_05 Sat.dslog"
            log.writeBytes(first)
            (folder / "2026_03_07 10_04_05 Sat.dsevents").writeBytes(second)
            val report = exporter.export(log, folder / "p.html")
            report.recording.topics.map { it.name } shouldContainAll listOf("Driver Station/Battery Voltage", "Driver Station/Events")
            val page = ReadPage(folder / "p.html")
            page.inflated() shouldBe first + second
            page.title shouldBe "MILLC Qualification 42"
            page.about.getValue("second").jsonPrimitive.content shouldBe "2026_03_07 10_04_05 Sat.dsevents"
            page.about.getValue("firstBytes").jsonPrimitive.content shouldBe "48"
        }
    }

    test("the second file of a log determines the page's title, even if both files' names contradict it") {
        inFolder { folder ->
            val log = folder / "Q7.dslog"
            log.writeBytes(first)
            (folder / "Q7.dsevents").writeBytes(second)
            exporter.export(log, folder / "p.html")
            ReadPage(folder / "p.html").title shouldBe "MILLC Qualification 42"
            (folder / "Q7.dsevents").deleteExisting()
            exporter.export(log, folder / "p.html")
            ReadPage(folder / "p.html").title shouldBe "Qualification 7"
        }
    }

    test("attachments are in the page, in their order") {
        inFolder { folder ->
            val files = listOf("notes.txt", "auto.json").map { folder / it }
            files.forEach { it.writeText("I am ${it.name}") }
            (folder / "a.bag").writeText(BAG)
            HtmlExporter(files, parts = parts).export(folder / "a.bag", folder / "p.html")
            val attachments = ReadPage(folder / "p.html").attachments
            attachments.keys.toList() shouldContainExactly listOf("notes.txt", "auto.json")
            attachments.getValue("notes.txt").decodeToString() shouldBe "I am notes.txt"
        }
    }

    test("the page's folder is created") {
        inFolder { folder ->
            (folder / "a.bag").writeText(BAG)
            val page = folder / "new" / "deep" / "p.html"
            exporter.export(folder / "a.bag", page).page shouldBe page.toAbsolutePath()
            ReadPage(page).inflated().decodeToString() shouldBe BAG
        }
    }

    context("a failed export leaves an older page unchanged, and no other file") {
        fun failing(bytes: ByteArray, run: (input: Path, page: Path) -> Unit) = inFolder { folder ->
            val page = folder / "p.html"
            page.writeText("older")
            (folder / "a.bag").writeBytes(bytes)
            run(folder / "a.bag", page)
            page.readText() shouldBe "older"
            folder.names() shouldContainExactly listOf("a.bag", "p.html")
        }
        val large = (BAG + "0.0400,3.0000\n".repeat(200_000)).encodeToByteArray()

        test("of a file of nonsense") {
            failing(byteArrayOf(1, 2, 3, 0, -1)) { input, page ->
                shouldThrow<ExportException.NotARecording> { exporter.export(input, page) }
                    .message shouldContain "a.bag"
            }
        }
        test("of a text of one column, recognized only at its end") {
            failing("just words\n".repeat(100_000).encodeToByteArray()) { input, page ->
                shouldThrow<ExportException.NotARecording> { exporter.export(input, page) }
            }
        }
        test("canceled by its progress") {
            failing(large) { input, page ->
                val stop = IllegalStateException("stop")
                shouldThrow<IllegalStateException> { exporter.export(input, page) { _, _ -> throw stop } } shouldBe stop
            }
        }
        test("canceled by its progress with an exception that files also throw") {
            for (stop in listOf(IOException("stop"), ClosedByInterruptException())) {
                failing(large) { input, page ->
                    shouldThrow<IOException> { exporter.export(input, page) { _, _ -> throw stop } } shouldBe stop
                }
            }
        }
        test("canceled by an interrupt") {
            for (bytes in listOf(large, gzip(large))) {
                failing(bytes) { input, page ->
                    shouldThrow<InterruptedException> {
                        exporter.export(input, page) { _, _ -> Thread.currentThread().interrupt() }
                    }
                    Thread.interrupted()
                }
            }
        }
        test("with a missing attachment") {
            failing(large) { input, page ->
                val missing = input.resolveSibling("nix.txt")
                shouldThrow<ExportException.Unreadable> { HtmlExporter(listOf(missing), parts = parts).export(input, page) }
                    .message shouldContain "nix.txt"
            }
        }
    }

    test("no thread outlives its export") {
        pageOf(BAG.encodeToByteArray()) { _, _ -> }
        Thread.getAllStackTraces().keys.map { it.name.substringBeforeLast('-') } shouldNotContain "badlog-deflate"
    }

    test("a page never overwrites an input or a folder") {
        inFolder { folder ->
            val input = (folder / "a.html").apply { writeText(BAG) }
            shouldThrow<ExportException.Unwritable> { exporter.export(input, folder / "." / "a.html") }
            shouldThrow<ExportException.Unwritable> { exporter.export(input, (folder / "sub").createDirectory()) }
            shouldThrow<ExportException.Unwritable> { exporter.export(input, input / "p.html") }
                .message shouldContain "folder"
            input.readText() shouldBe BAG
        }
    }

    test("a missing input, or a folder as input, is named in the error") {
        inFolder { folder ->
            shouldThrow<ExportException.Unreadable> { exporter.export(folder / "nix", folder / "p.html") }
                .message shouldContain "There is no file or folder ${folder / "nix"}"
            shouldThrow<ExportException.Unreadable> { exporter.export(folder, folder / "p.html") }
                .message shouldContain "${folder.name} is a folder"
        }
    }
})
