package badlog.page

import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.awt.image.BufferedImage
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64
import javax.imageio.ImageIO
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** The printed page, read back from a PDF by poppler's programs. */
@Tags("InCheck")
internal class PrintSpec : PageSpec({
    val match by lazy { TestPages.ofSample("qualification-42.bag", PageAdditions(rules = RuleSet.BUILT_IN)) }

    fun printTest(name: String, test: suspend () -> Unit) = test(name).config(
        enabledOrReasonIf = { if (hasPoppler) Chromium.enabled else Enabled.disabled("pdftotext and pdftoppm (poppler-utils) are missing") },
    ) { test() }

    printTest("findings, the board and all graphs are printed, with the part of the log and the values at the cursor") {
        onPage(match, Screen(1366, 768)) {
            step("findings and the whole board are printed, every graph as wide as the paper and on one page with its axis") {
                val titles = texts(".board .graph-title")
                titles.size shouldBeGreaterThan 4
                val pdf = print()
                val text = pdf.pages.joinToString("\n")
                text.indexOf("The roboRIO browned out") shouldBeGreaterThan -1
                text.indexOf(titles.first(), text.indexOf("Board")) shouldBeGreaterThan text.indexOf("The roboRIO browned out")
                for (page in pdf.pages) {
                    val graphs = titles.filter { title -> page.lines().any { it.trim().startsWith("$title (") || it.trim() == title } }
                    withClue("$graphs on a page, and the titles of their x axes:\n$page") {
                        page.lines().count { it.trim() == "Time (s)" } shouldBe graphs.size
                    }
                }
                titles.filter { title -> pdf.pages.any { title in it } } shouldHaveSize titles.size
                pdf.pictures.forEach { it.requireMargin() }
                // The voltage of the first graph goes from the left of the paper to its right.
                val picture = pdf.pictures[pdf.pages.indexOfFirst { titles.first() in it }]
                val columns = (0 until picture.width).filter { x -> (0 until picture.height).any { y -> isBlue(picture.getRGB(x, y)) } }
                columns.size.toDouble() / picture.width shouldBeGreaterThan 0.7
                columns.last().toDouble() / picture.width shouldBe (0.92 plusOrMinus 0.06)
            }
            step("all graphs are printed on request, and only once") {
                // A test cannot answer the browser's own dialog.
                script("window.print = () => {}")
                selectIn("#export", "Print all graphs")
                val drawn = number("return document.querySelectorAll('.graph').length").toInt()
                val all = print().pages.joinToString("\n")
                all.lines().count { it.trim() == "Time (s)" } shouldBe drawn
                texts(".graph-title").filter { it !in all.replace(Regex("\\s+"), " ") } shouldBe emptyList()
                print().pages.joinToString("\n").lines().count { it.trim() == "Time (s)" } shouldBe texts(".board .graph-title").size
            }
            show(Screen.PHONE)
            step("the printed page names its part of the log, and has the values at the cursor") {
                script("location.hash = '#t=93.7&x=90:100'")
                settle()
                val text = print().pages.joinToString("\n")
                text shouldContain "qualification-42.bag · 90.000 – 100.000 s · cursor at 93.700 s"
                text shouldContain "Battery Voltage ${texts(".board .value").first()} V"
                text shouldNotContain "Reset zoom"
            }
        }
    }

    printTest("a page without a board prints its graphs, and a dark page is dark again afterwards") {
        onPage(TestPages.of(stepBag(graphs = 9)), Screen(1366, 768, isDark = true)) {
            val before = color("--surface")
            val pdf = print()
            pdf.pages.joinToString("\n").lines().map { it.trim() } shouldContainAll (1..9).map { "Step $it (V)" }
            pdf.pictures.forEach { it.requireMargin() }
            color("--surface") shouldBe before
            elements(".paper svg, svg.paper").size shouldBe 0
            elements("[data-print]").size shouldBe 0
        }
    }
})

/** A PDF by its visible content: the text and the picture of each page. */
private class Pdf(private val bytes: ByteArray) {
    val pages: List<String> by lazy { read { output("pdftotext", "-layout", "$it", "-").trimEnd('\u000c').split('\u000c') } }

    val pictures: List<BufferedImage> by lazy {
        read { pdf ->
            output("pdftoppm", "-r", "75", "-png", "$pdf", "${pdf.resolveSibling("picture")}")
            pdf.parent.listDirectoryEntries("picture*.png").sortedBy { it.name }.map { ImageIO.read(it.toFile()) }
        }
    }

    private fun <T> read(work: (Path) -> T): T {
        val folder = Files.createTempDirectory("badlog-print")
        return try {
            work(Files.write(folder.resolve("page.pdf"), bytes))
        } finally {
            folder.toFile().deleteRecursively()
        }
    }
}

/** Prints the page as it is now. */
private fun OpenPage.print(): Pdf {
    val result = driver.executeCdpCommand("Page.printToPDF", mapOf("paperWidth" to 8.27, "paperHeight" to 11.69))
    return Pdf(Base64.getDecoder().decode(result["data"] as String))
}

private fun output(vararg command: String): String {
    val process = ProcessBuilder(*command).redirectErrorStream(true).start()
    val text = process.inputStream.readAllBytes().decodeToString()
    check(process.waitFor() == 0) { "${command.first()} failed: $text" }
    return text
}

private val hasPoppler: Boolean by lazy {
    val folders = System.getenv("PATH").orEmpty().split(File.pathSeparator).map(Path::of)
    listOf("pdftotext", "pdftoppm").all { program -> folders.any { Files.isExecutable(it.resolve(program)) } }
}

/** Checks that nothing reaches the edge of the paper, where it would be cut, and that the paper is light. */
private fun BufferedImage.requireMargin() {
    for (y in 0 until height) for (x in listOf(1, width - 10, width - 2)) getRGB(x, y) and 0xffffff shouldBe 0xffffff
}

/** Returns whether [color] is the color of a first line, which antialiasing may change on a thin line. */
private fun isBlue(color: Int): Boolean = (color shr 16 and 0xff) < 90 && (color and 0xff) > 150
