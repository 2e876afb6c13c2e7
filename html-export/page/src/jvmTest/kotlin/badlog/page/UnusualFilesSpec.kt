package badlog.page

import badlog.core.bag.BagTopic
import badlog.exporter.EmptyPage
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.nio.file.Files
import kotlin.io.path.div

private const val HEADER =
    """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"A","unit":"V","attrs":[]}],"values":[]}"""

/** Files that no robot should write, but robots write. The page opens, and reports their problems. */
@Tags("InCheck")
internal class UnusualFilesSpec : PageSpec({
    val folder by lazy { Files.createTempDirectory("badlog-unusual") }
    val page by lazy { (folder / EmptyPage.NAME).also { EmptyPage().write(it) } }

    afterSpec { folder.toFile().deleteRecursively() }

    /** Drops a log with this [text] on the page. */
    fun OpenPage.open(text: String, name: String = "test.bag") {
        drop(name to text.encodeToByteArray())
        await("the log") { texts(".page-title h1").size == 1 }
        awaitState("ready")
    }

    fun OpenPage.leave() {
        click("#go-back")
        awaitState("empty")
    }

    /** Returns the problems that the page shows. */
    fun OpenPage.problems(): String {
        if (elements(".problem-list").isEmpty()) click("#problems summary")
        return element("#problems").text
    }

    browserTest("files that no robot should write are shown with their problems") {
        onPage(page, state = "empty") {
            step("a file with only a header shows its topics") {
                open("$HEADER\n")
                text shouldContain "A"
            }
            leave()
            step("a file with one row shows its value, and no range") {
                open("$HEADER\nTime,A\n5.0,3.0\n")
                graph("A").scrollTo().hover(0.5)
                graph("A").value("A") shouldBe "3"
                graph("A").pixelsOfLine(0) shouldBeGreaterThan 0
                graph("A").drag(0.2, 0.6)
                texts(".fact").none { it.endsWith(" s") } shouldBe true
                texts(".range-readout .range").single() shouldNotContain "–"
            }
            leave()
            step("a unit in right-to-left writing is isolated from the text beside it") {
                open("{\"topics\":[{\"name\":\"A\",\"unit\":\"متر\"}],\"values\":[]}\nA\n1\n2\n", "متر.bag")
                (elements(".fact") + elements(".graph-unit")).map { it.tagName }.toSet() shouldBe setOf("bdi")
            }
            leave()
            step("infinities are labeled, a single sample among gaps is visible, and topics of only NaN or gaps have no data") {
                val topics = listOf("Broken", "Gaps", "A", "One").joinToString("") { ",{\"name\":\"$it\",\"unit\":\"V\"}" }
                val header = "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\",\"hide\"]}$topics],\"values\":[]}"
                val rows = listOf("0,NaN,,1,", "1,NaN,,Infinity,", "2,NaN,,NaN,7", "3,NaN,,-Infinity,", "4,NaN,,2,")
                open("$header\nTime,Broken,Gaps,A,One\n${rows.joinToString("\n")}\n")
                graphNames shouldBe listOf("Broken", "Gaps", "A", "One")
                await("two graphs without data") { texts(".plot").count { it == "No data" } == 2 }
                graph("A").scrollTo().hover(0.25)
                graph("A").value("A") shouldBe "∞"
                graph("A").hover(0.75)
                graph("A").value("A") shouldBe "-∞"
                graph("One").scrollTo().hover(0.5)
                graph("One").value("One") shouldBe "7"
                graph("One").pixelsOfLine(0) shouldBeGreaterThan 0
            }
            leave()
            step("names of 500 letters do not make the page wider than the window") {
                val long = "Very".repeat(125)
                val joined = BagTopic("A", attributes = listOf("join:$long B"))
                val topics = listOf(TIME, BagTopic(long, long), BagTopic("$long/$long"), joined)
                val values = mapOf(long to long, "Event Name" to long)
                open(bagOf(topics, 50, values) { row, _ -> row }.decodeToString())
                graphNames shouldContain long
                for (screen in listOf(Screen.PHONE, Screen.WIDE)) {
                    show(screen)
                    number("return document.documentElement.scrollWidth - innerWidth") shouldBeLessThanOrEqual 0.0
                }
            }
        }
    }
})
