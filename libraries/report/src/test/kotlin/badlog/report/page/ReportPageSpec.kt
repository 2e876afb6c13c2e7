package badlog.report.page

import badlog.exporter.ExportException
import badlog.exporter.HtmlExporter
import badlog.exporter.PageParts
import badlog.files.LogFile
import badlog.files.inFolder
import badlog.report.Report
import badlog.report.bag
import badlog.report.batteryBag
import badlog.report.logsIn
import badlog.report.put
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.nio.file.Files
import java.nio.file.Path
import javax.xml.parsers.DocumentBuilderFactory

private const val HOSTILE = "<script>alert(1)</script>\"'&"

class ReportPageSpec : FunSpec({
    test("texts from files are shown literally, and only the page's own style and script are allowed") {
        inFolder { folder ->
            folder.put("1.bag", bag(mapOf("Time" to "s", HOSTILE to "V"), listOf("0,1"), mapOf("Event" to HOSTILE, "Match Number" to "1")))
            val rules = RulesFile.parse("[[rule]]\nname='<b>'\nseverity='error'\neach='*'\nwhen='topic > 0'\ntext='{topic} <i> {match}'").rules
            val page = reportPage(Report(rules).over(logsIn(folder)), HOSTILE) { "javascript:alert(1)/a b#?.html" }
            page.split("<script").size shouldBe 2
            page shouldNotContain "<i>"
            page shouldContain "&lt;script&gt;alert(1)&lt;/script&gt;&quot;&#39;&amp; &lt;i&gt;"
            page shouldContain "href=\"./javascript%3Aalert%281%29/a%20b%23%3F.html#t=0&amp;finding=~003cb~003e;~003cscript~003e"
            val style = page.substringAfter("<style>").substringBefore("</style>")
            val script = page.substringAfter("<script>").substringBefore("</script>")
            page shouldContain "default-src 'none'; style-src '${hashOf(style)}'; script-src '${hashOf(script)}'; base-uri 'none'; form-action 'none'"
            page shouldNotContain "style=\""
            // Except for elements that HTML leaves open, it is well formed.
            val body = page.substringAfter("<body>").substringBefore("<script>").replace("<br>", "<br/>")
            DocumentBuilderFactory.newInstance().newDocumentBuilder().parse("<body>$body</body>".byteInputStream())
        }
    }

    test("the pages of the logs are written beside the index, each with a name of its own") {
        inFolder { folder ->
            folder.put("logs/a/Q1.bag", batteryBag(6.0, 6.0))
            folder.put("logs/b/Q1.csv", "Time,Volts\n0,1\n1,2\n")
            folder.put("logs/index.bag", batteryBag(12.0))
            folder.put("logs/z.csv", "words\nand words\n")
            val rules = RulesFile.parse("[[rule]]\nname='R'\nseverity='note'\nwhen='min(Battery Voltage) < 7'\ntext='low'").rules
            val out = folder.resolve("out/report")
            val exporter = HtmlExporter(parts = PageParts("", ""))
            val logs = logsIn(folder.resolve("logs"))
            val report = ReportFolder(out, logs, rules, exporter = exporter)
            val index = report.writeIndex(Report(rules).over(logs) { log, hooks -> report.add(log, hooks) })
            Files.list(out).use { files -> files.map { it.fileName.toString() }.toList() }.sorted() shouldBe
                listOf("Q1 (2).html", "Q1.html", "index (2).html", "index.html")
            Files.readString(index) shouldContain "href=\"./Q1.html#t=0&amp;finding=R"
            Files.readString(index) shouldContain "href=\"./index%20%282%29.html\""
        }
    }

    test("badlog's own files are replaced, others only if forced, and input files never") {
        inFolder { folder ->
            val log = folder.put("index.html", batteryBag(6.0))
            folder.put("Q1.bag", batteryBag(6.0))
            val logs = listOf(log, folder.resolve("Q1.bag")).map { LogFile.of(it) }
            val exporter = HtmlExporter(parts = PageParts("", ""))
            fun report(out: Path, isForced: Boolean) {
                val pages = ReportFolder(out, logs, RuleSet.NONE, isForced = isForced, exporter = exporter)
                pages.checkIndex()
                pages.writeIndex(Report(RuleSet.NONE).over(logs) { read, hooks -> pages.add(read, hooks) })
            }
            val own = Files.readString(log)
            shouldThrow<ExportException> { report(folder, isForced = true) }.message shouldContain
                "would overwrite a file that is read; name another place with --out."
            Files.readString(log) shouldBe own

            val out = folder.resolve("out")
            repeat(2) { report(out, isForced = false) }
            folder.put("out/Q1.html", "mine")
            shouldThrow<ExportException> { report(out, isForced = false) }.message shouldContain "badlog did not make it"
            Files.readString(out.resolve("Q1.html")) shouldBe "mine"
            report(out, isForced = true)
            Files.readString(out.resolve("Q1.html")).take(15) shouldBe "<!DOCTYPE html>"
        }
    }

    test("a log with the longest possible name has a page") {
        inFolder { folder ->
            val log = LogFile.of(folder.put("\u00e9".repeat(125) + ".bag", batteryBag(6.0)))
            val pages = ReportFolder(folder.resolve("out"), listOf(log), RuleSet.NONE, exporter = HtmlExporter(parts = PageParts("", "")))
            Report(RuleSet.NONE).over(listOf(log)) { read, hooks -> Files.exists(checkNotNull(pages.add(read, hooks))) shouldBe true }
        }
    }
})
