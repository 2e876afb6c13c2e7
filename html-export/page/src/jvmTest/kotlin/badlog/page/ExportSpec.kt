package badlog.page

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.bag.BagTopic
import badlog.core.bag.RecordingWriter
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Severity
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.viewer.draw.color.lineColor
import badlog.viewer.shown.table.CsvTable
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import org.w3c.dom.Document
import java.awt.image.BufferedImage
import java.io.ByteArrayOutputStream
import java.nio.file.Files
import javax.imageio.ImageIO
import javax.xml.parsers.DocumentBuilderFactory

@Tags("InCheck")
internal class ExportSpec : PageSpec({
    val match by lazy { TestPages.ofSample("qualification-42.bag", PageAdditions(rules = RuleSet.BUILT_IN)) }

    /** Goes to the brownout of [match]. */
    fun OpenPage.toBrownout() {
        script("location.hash = '#t=93.7'")
        settle()
    }

    fun read(bytes: ByteArray, name: String): Recording = readRecording(Files.write(Files.createTempDirectory("badlog-export").resolve(name), bytes), LOG_FORMATS)

    fun textOf(table: CsvTable) = table.header + table.text(0, table.rowCount)

    browserTest("a drawing of the board has the match, the values at the cursor and the findings, and a picture has its lines") {
        onPage(match, Screen(1280, 900, isDark = true)) {
            toBrownout()
            val drawing = xml(exported("Board as a drawing (SVG)", "qualification-42 Board.svg"))
            val texts = drawing.texts()
            texts shouldContain "Mill Creek Regional Qualification 42"
            texts.single { it.startsWith("qualification-42.bag · 0.00 – 155.99 s · cursor at 93.70 s · Teleop 1:31") }
            texts shouldContainAll listOf("Battery and current", "Loop Time (ms)", "Time (s)", "error · 93.71 s")
            texts.single { it.startsWith("Browned out: ") } shouldContain "The roboRIO browned out"
            texts.single { it.startsWith("Battery Voltage ") } shouldBe "Battery Voltage ${texts(".board .value").first()} V"
            // Paper is light.
            drawing.documentElement.firstChild.attributes.getNamedItem("fill").nodeValue shouldBe "#ffffff"
            val picture = image(exported("Board as an image (PNG)", "qualification-42 Board.png"))
            picture.width shouldBe 1000
            picture.height shouldBeGreaterThan 5 * 120
            picture.getRGB(2, 2) and 0xffffff shouldBe 0xffffff
            // The right half has no legends. Four graphs draw lines there, with gaps between them.
            val rows = (0 until picture.height).filter { y -> (500 until 1000).any { x -> picture.getRGB(x, y) and 0xffffff in LINES } }
            rows.zipWithNext().count { (one, next) -> next - one > 30 } + 1 shouldBeGreaterThan 3
        }
    }

    browserTest("the visible range is saved as the same CSV as in the window, and the board as CSV with only its own topics") {
        val bag = stepBag(graphs = 3)
        onPage(TestPages.of(bag, "steps.bag")) {
            script("location.hash = '#x=2:6&t=4'")
            settle()
            val csv = exported("Visible range as a table (CSV)", "steps range.csv").decodeToString()
            csv shouldBe textOf(CsvTable.ofAll(LogView.of(read(bag, "steps.bag")), Span(2.0, 6.0)))
            csv.lines().drop(1).first() shouldStartWith "2,"
            csv.trimEnd().lines().size shouldBe 402
            val pins = listOf("Step 3", "Step 1").map { ".graph[data-name='$it'] .pin" }
            for (pin in pins) script("document.querySelector(arguments[0]).click()", pin)
            settle()
            exported("Board as a table (CSV)", "steps Board.csv").decodeToString().lines().first() shouldBe "Time (s),Step 3 (V),Step 1 (V)"
        }
    }

    browserTest("saved files of graphs and damaged logs have the content of the log") {
        step("one graph is saved as a picture, as a drawing and as a table") {
            onPage(TestPages.ofSample("elevator-bench.csv")) {
                val card = ".graph[data-name='Position'] .save-image"
                image(saved("elevator-bench Position.png") { selectIn(card, "Position as an image (PNG)") }).width shouldBe 1000
                xml(saved("elevator-bench Position.svg") { selectIn(card, "Position as a drawing (SVG)") }).texts() shouldContain "elevator-bench.csv"
                val view = LogView.of(readRecording(SAMPLES.resolve("elevator-bench.csv"), LOG_FORMATS))
                val position = view.recording.topics.first { it.name == "Position" }
                saved("elevator-bench Position.csv") { selectIn(card, "Position as a table (CSV)") }.decodeToString() shouldBe
                    textOf(CsvTable.of(view, null, listOf(view.seriesOf(position))))
                // Both downloads of a plain CSV file are the file itself.
                val csv = Files.readAllBytes(SAMPLES.resolve("elevator-bench.csv"))
                for (button in listOf("#download", "#download-csv")) saved("elevator-bench.csv") { click(button) } shouldBe csv
            }
        }
        step("the CSV of a damaged log has the repaired cells, and its file is saved byte for byte") {
            val name = "practice.bag"
            val damaged = readRecording(SAMPLES.resolve(name), LOG_FORMATS)
            damaged.problems.size shouldBeGreaterThan 0
            val written = ByteArrayOutputStream()
            RecordingWriter(damaged, RecordingFormat.CSV).write(0, damaged.rowCount) { bytes, size -> written.write(bytes, 0, size) }
            val wanted = read(written.toByteArray(), "converted.csv")
            onPage(TestPages.ofSample(name)) {
                saved(name) { click("#download") } shouldBe Files.readAllBytes(SAMPLES.resolve(name))
                val bytes = saved("$name.csv") { click("#download-csv") }
                val repaired = read(bytes, "page.csv")
                repaired.problems.filter { it.severity > Severity.NOTE }.shouldBeEmpty()
                repaired.rowCount shouldBe wanted.rowCount
                for (topic in wanted.topics) {
                    val same = repaired.topics.first { it.name.substringBefore(" (") == topic.name.substringBefore(" (") }
                    same.samples.map(Double::toString) shouldBe topic.samples.map(Double::toString)
                    same.texts.size shouldBe topic.texts.size
                }
            }
        }
    }

    browserTest("a slow table is made while the page stays responsive; it shows its progress, and closing that cancels it") {
        // Each read of the clock takes 50 ms, as a row of a log of many thousand topics may.
        val slow = "{ let late = 0; const now = Date.now.bind(Date); Date.now = () => now() + (window.isSlow ? late += 50 : late) }"
        val bag = bagOf(listOf(TIME, BagTopic("A", "V")), 200) { row, column -> if (column == 0) row / 50.0 else row }
        onPage(TestPages.of(bag, "large.bag"), script = slow) {
            fun said() = texts(".notice p").single()
            // The page itself cancels, because the table may be done before a test can.
            script(
                """
                window.isSlow = true
                const said = document.querySelector('.notice p')
                new MutationObserver((changes, observer) => {
                    if (!/^Making the table: [1-9]/.test(said.textContent)) return
                    observer.disconnect()
                    window.share = said.textContent
                    document.querySelector('.notice button').click()
                }).observe(said, {childList: true, characterData: true, subtree: true})
                """.trimIndent(),
            )
            selectIn("#export", "Visible range as a table (CSV)")
            await("a first part") { script("return window.share ?? null") != null }
            settle()
            said() shouldBe ""
            // The canceled file does not appear later: the next file with this name is complete.
            exported("Visible range as a table (CSV)", "large range.csv").decodeToString().trimEnd().lines().size shouldBe 201
            said() shouldBe ""
        }
    }
})

/** The colors of the first three lines on paper. */
private val LINES = (0 until 3).map { lineColor(it, isDark = false) }

private fun image(bytes: ByteArray): BufferedImage = ImageIO.read(bytes.inputStream())

private fun xml(bytes: ByteArray): Document = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(bytes.inputStream())

private fun Document.texts(): List<String> = getElementsByTagName("text").let { all -> (0 until all.length).map { all.item(it).textContent } }
