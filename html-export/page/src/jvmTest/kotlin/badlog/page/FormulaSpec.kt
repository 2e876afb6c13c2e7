package badlog.page

import badlog.core.bag.BagTopic
import badlog.protocol.PageAdditions
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys

@Tags("InCheck")
internal class FormulaSpec : PageSpec({
    val topics = listOf(TIME, BagTopic("Power/Voltage", "V"), BagTopic("Power/Current"), BagTopic("9 lives"))
    val bag = bagOf(topics, 101) { row, column -> if (column == 0) row / 10.0 else row * column }

    /** Waits until the formula [name] is calculated, which takes several slices on a slow machine. */
    fun OpenPage.awaitGraph(name: String) = await("the graph of $name") { name in graphNames }

    fun OpenPage.addFormula(definition: String) {
        click("#add-formula")
        press(definition, Keys.ENTER)
        awaitGraph(definition.substringBefore(" ="))
    }

    browserTest("formulas are added, removed and completed, and their mistakes are shown") {
        onPage(TestPages.of(bag)) {
            step("a new formula has a graph at once and after a reload, does not count as a topic of the log, and can be removed") {
                press("f")
                press("Power/Sum [x] = Voltage + Current")
                press(Keys.ENTER)
                element("#formula-dialog").isDisplayed shouldBe false
                awaitGraph("Power/Sum")
                graph("Power/Sum").scrollTo().hover(0.5)
                graph("Power/Sum").value("Sum") shouldBe "150"
                press("f")
                press("New folder/Twice = Sum * 2", Keys.ENTER)
                awaitGraph("New folder/Twice")
                texts(".folder-link-name") shouldContain "New folder"
                reload()
                texts(".fact") shouldContain "4 topics"
                texts("#info .value-row").single { it.startsWith("Topics") } shouldBe "Topics4"
                graphNames shouldContain "Power/Sum"
                graph("New folder/Twice").scrollTo().hover(0.5)
                graph("New folder/Twice").value("Twice") shouldBe "300"
                click("#add-formula")
                elements(".formula-remove").last().click()
                elements(".formula-remove").last().click()
                press(Keys.ESCAPE)
                graphNames shouldNotContain "Power/Sum"
                texts(".folder-link-name") shouldNotContain "New folder"
                reload()
                graphNames shouldNotContain "Power/Sum"
            }
            startOver()
            step("a mistake is shown while it is typed, and Enter does not accept it; names are suggested, with quotes if necessary") {
                click("#add-formula")
                press("Right = Voltage + ")
                element(".formula-dialog .pointer").isDisplayed shouldBe true
                press(Keys.ENTER)
                element("#formula-dialog").isDisplayed shouldBe true
                press("Current")
                element(".formula-dialog .pointer").isDisplayed shouldBe false
                press(Keys.ENTER)
                awaitGraph("Right")
                click("#add-formula")
                press("Sum = volt")
                texts(".formula-suggestions button") shouldBe listOf("Power/Voltage")
                click(".formula-suggestions button")
                press(" + 9")
                texts(".formula-suggestions button") shouldBe listOf("\"9 lives\"")
                click(".formula-suggestions button")
                press(Keys.ENTER)
                awaitGraph("Sum")
                graph("Sum").scrollTo().hover(0.5)
                graph("Sum").value("Sum") shouldBe "200"
            }
        }
    }

    /** Each read of the clock takes 200 ms, as for a log of many million samples. Timers wait until they are released. */
    val slow = """
        (() => {
            const now = performance.now.bind(performance), set = window.setTimeout
            let late = 0
            window.held = []
            performance.now = () => now() + (window.isSlow ? late += 200 : late)
            window.setTimeout = (work, ...more) => window.isSlow ? window.held.push(work) : set(work, ...more)
            window.release = count => { while (count-- > 0 && window.held.length > 0) window.held.shift()() }
        })()
    """
    val five = (1..5).joinToString(";") { "F$it+~003d+Voltage~002a$it" }
    val isAllThere = listOf("F1", "F2", "F3", "F4", "F5")

    browserTest("the formulas of a link are calculated in slices, to which another formula can be added") {
        onPage(TestPages.of(bag), script = slow) {
            step("the formulas of a link are calculated in slices; a long calculation shows its progress, and closing that cancels it") {
                script("window.isSlow = true; location.hash = '#f=$five&t=3'")
                await("a slice") { number("return held.length") > 0 }
                script("release(3)")
                texts(".notice p").single() shouldContain "Calculating the formulas: "
                graphNames shouldNotContain "F1"
                script("document.querySelector('.notice button').click(); release(99); window.isSlow = false")
                graphNames shouldNotContain "F1"
                // The page continues, also with the same formulas.
                addFormula("F1 = Voltage * 1")
                graphNames shouldContain "F1"
                script("location.hash = '#f=$five&t=4'")
                await("the formulas") { graphNames.containsAll(isAllThere) }
                graphNames.count { it == "F1" } shouldBe 1
                await("its moment") { texts(".cursor-readout").single().startsWith("4.0") }
            }
            startOver()
            step("a formula added during a calculation does not lose the others") {
                script("window.isSlow = true; location.hash = '#f=$five'")
                await("a slice") { number("return held.length") > 0 }
                script("window.isSlow = false")
                click("#add-formula")
                press("Sum = Voltage + Current", Keys.ENTER)
                script("release(99)")
                await("all formulas") { graphNames.containsAll(isAllThere + "Sum") }
                graphNames.filter { it in isAllThere + "Sum" } shouldBe isAllThere + "Sum"
            }
        }
    }

    browserTest("a page is drawn once its own, its reader's and a link's formulas are calculated") {
        onPage(TestPages.of(bag, additions = PageAdditions(listOf("Half = Voltage / 2"))), script = slow) {
            addFormula("Quarter = Half / 2")
            script("location.hash = '#f=$five'")
            await("the formulas") { graphNames.containsAll(isAllThere) }
            reload()
            graphNames.filter { it in isAllThere + listOf("Half", "Quarter") } shouldBe listOf("Half", "Quarter") + isAllThere
            // The link's formulas become the reader's own only when the reader changes something.
            script("history.replaceState(null, '', location.pathname)")
            reload()
            graphNames shouldContain "Quarter"
            graphNames shouldNotContain "F1"
        }
    }
})
