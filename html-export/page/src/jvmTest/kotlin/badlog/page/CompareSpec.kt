package badlog.page

import badlog.core.bag.BagTopic
import badlog.files.gzip
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.By
import org.openqa.selenium.Keys
import java.nio.file.Files

private const val VOLTS = "Battery Voltage"

/** Several logs on one page. */
@Tags("InCheck")
internal class CompareSpec : PageSpec({
    val topics = listOf(TIME, BagTopic(VOLTS, "V"), BagTopic("Enabled"), BagTopic("State"))

    /** A log that begins at [start], in which the robot is enabled [enabledAfter] seconds later, and the battery has [volts]. */
    fun log(start: Double, enabledAfter: Double, volts: Double) = bagOf(topics, rows = 101) { row, column ->
        when (column) {
            0 -> start + row / 10.0
            1 -> volts
            2 -> if (row / 10.0 >= enabledAfter) 1 else 0
            else -> if (row < 30) "IDLE" else "SHOOT"
        }
    }

    val own = log(0.0, 2.0, 12.0)
    val page by lazy { TestPages.of(own, "own.bag", PageAdditions(rules = RuleSet.NONE.with(RuleSet.BUILT_IN.signals))) }

    fun OpenPage.awaitLogs(count: Int) = await("$count logs") { number("return document.querySelectorAll('#compare:not([hidden]) .compared-log').length") == count.toDouble() }

    fun OpenPage.legend() = texts(".graph[data-name='$VOLTS'] .legend-name").zip(texts(".graph[data-name='$VOLTS'] .legend .value")) { name, value -> "$name $value" }

    browserTest("logs are compared, moved, calculated with, and removed again") {
        val folder = tempdir().toPath()
        val files = listOf("a.bag" to log(0.0, 2.0, 11.0), "pit.bag" to byteArrayOf(-1, -40, -1, 0), "b.bag" to log(5.0, 2.0, 10.0))
            .map { (name, bytes) -> Files.write(folder.resolve(name), bytes) }
        onPage(page) {
            step("a dropped log is drawn over the page's own in each graph, with its values at the cursor and in the statistics") {
                element("#compare").isDisplayed shouldBe false
                compare("other.bag" to log(100.0, 3.0, 11.0))
                awaitLogs(2)
                texts(".compared-log .cut-name") shouldContainExactly listOf("own.bag", "other.bag")
                graph(VOLTS).click(0.5)
                legend() shouldContainExactly listOf("$VOLTS 12", "$VOLTS (other.bag) 11")
                texts(".graph[data-name='State'] .legend-name") shouldContainExactly listOf("State", "State (other.bag)")
                graph(VOLTS).card.findElement(By.cssSelector(".statistics-toggle")).click()
                texts(".statistics .lines tbody th") shouldContainExactly listOf(VOLTS, "$VOLTS (other.bag)")
                texts(".statistics .differences tbody th") shouldContainExactly listOf("$VOLTS (other.bag) − $VOLTS")
                keepScreenshot("compare")
                seriousForReaders() shouldBe emptyList()
            }
            element("#compare [aria-label='Stop comparing']").click()
            press(Keys.ESCAPE)
            step("several logs are read one after the other, also gzipped ones, and each can be removed; a search continues meanwhile") {
                press("/", VOLTS)
                settle()
                graphNames shouldContainExactly listOf(VOLTS)
                compare("a.bag" to log(0.0, 2.0, 11.0), "b.bag.gz" to gzip(log(5.0, 2.0, 10.0)))
                awaitLogs(3)
                settle()
                graphNames shouldContainExactly listOf(VOLTS)
                press(Keys.ESCAPE)
                graph(VOLTS).scrollTo().click(0.5)
                legend() shouldContainExactly listOf("$VOLTS 12", "$VOLTS (a.bag) 11", "$VOLTS (b.bag.gz) 10")
                elements(".compared-log .icon-button")[0].click()
                legend().size shouldBe 2
                element("#compare [aria-label='Stop comparing']").click()
                element("#compare").isDisplayed shouldBe false
                texts(".graph[data-name='State'] .legend-name") shouldContainExactly listOf("State")
            }
            step("all files that are chosen at once are compared; a file that is not a log is named after the others were read") {
                for ((name, bytes) in listOf("pit.jpg" to byteArrayOf(-1, -40, -1, 0, 0, 16), "empty.bag" to ByteArray(0))) {
                    compare(name to bytes)
                    await("the sentence") { name in texts(".notice p").single() && "Reading" !in texts(".notice p").single() }
                    element("#compare").isDisplayed shouldBe false
                }
                element("#compare-file").sendKeys(files.joinToString("\n"))
                awaitLogs(3)
                texts(".compared-log .cut-name") shouldContainExactly listOf("own.bag", "a.bag", "b.bag")
                await("the sentence") { "pit.bag" in texts(".notice p").single() && "Reading" !in texts(".notice p").single() }
            }
            element("#compare [aria-label='Stop comparing']").click()
            step("a formula of the page is calculated for all logs, whichever came first") {
                fun addFormula(text: String) {
                    press("f")
                    press(text, Keys.ENTER)
                    await("its graph") { text.substringBefore(" [") in graphNames }
                }
                addFormula("First [V] = $VOLTS * 2")
                compare("other.bag" to log(100.0, 3.0, 11.0))
                awaitLogs(2)
                addFormula("Second [V] = $VOLTS * 3")
                for (name in listOf("First", "Second")) {
                    graph(name).card.findElements(By.cssSelector(".legend-entry")).size shouldBe 2
                }
            }
        }
    }

    browserTest("compared logs are named after their match, whether dropped or exported with the page") {
        step("a page exported with other logs begins with them, also on a phone, and matches of one event are named by their number") {
            onPage(TestPages.ofSamples("qualification-42.bag", listOf("qualification-57.bag.gz"))) {
                awaitLogs(2)
                for (screen in listOf(Screen.WIDE, Screen.PHONE)) {
                    show(screen)
                    texts(".compared-log .cut-name") shouldContainExactly listOf("Qualification 42", "Qualification 57")
                    (number("return document.documentElement.scrollWidth - innerWidth") <= 0) shouldBe true
                    text shouldContain "Qualification 57"
                    keepScreenshot(if (screen === Screen.PHONE) "phone-compare" else "compare-exported")
                }
            }
        }
    }
})
