package badlog.page

import badlog.core.bag.BagTopic
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.By
import org.openqa.selenium.Keys

/** The graphs that a person puts together. */
@Tags("InCheck")
internal class BoardSpec : PageSpec({
    val topics = listOf(TIME, BagTopic("Volt", "V"), BagTopic("Amp", "A"), BagTopic("Speed", "rpm"), BagTopic("Other", "V"), BagTopic("Mode"))
    val bag by lazy {
        bagOf(topics, 1001) { row, column ->
            when (column) {
                0 -> row / 100.0
                5 -> if (row < 500) "auto" else "teleop"
                1 -> 99 - row % 100
                else -> row % 100 * column * column
            }
        }
    }
    val page by lazy { TestPages.of(bag) }

    fun OpenPage.titles() = texts("#board .graph-title")

    fun OpenPage.lines(graph: Int) = elements("#board .board-graph")[graph].findElements(By.cssSelector("[data-series]"))
        .map { it.getDomAttribute("data-series") }

    fun OpenPage.pin(name: String) {
        script("arguments[0].querySelector('.pin').click()", graph(name).card)
        settle()
    }

    fun OpenPage.focusGraph(index: Int) {
        script("document.querySelectorAll('#board .plot')[arguments[0]].focus({focusVisible: true})", index)
        settle()
    }

    /** Opens the menu of a graph of the board, and selects [entry]. */
    fun OpenPage.choose(graph: Int, entry: String) {
        elements("#board .graph-menu")[graph].click()
        settle()
        click("#board .menu button") { entry in it.text }
    }

    /** Drags the title of a graph of the board to the share [down] of another graph's height. */
    fun OpenPage.dragTitle(from: Int, to: Int, down: Double) {
        val places = script(
            """
            const middle = box => [box.x + Math.min(20, box.width / 2), box.y + box.height / 2]
            const from = document.querySelectorAll('#board .graph-title')[arguments[0]].getBoundingClientRect()
            const to = document.querySelectorAll('#board .board-graph')[arguments[1]].getBoundingClientRect()
            return [...middle(from), to.x + 60, to.y + to.height * arguments[2]].map(Math.round)
            """.trimIndent(),
            from,
            to,
            down,
        ) as List<*>
        val (x, y, toX, toY) = places.map { (it as Number).toInt() }
        act { mouseTo(x, y).mouseDown().mouseTo(x + 6, y + 6).mouseTo(toX, toY).mouseUp() }
    }

    /** Empties the board, as if no link had been followed. */
    fun OpenPage.clear() {
        script("history.replaceState(null, '', location.pathname); scrollTo(0, 0)")
        if (titles().isNotEmpty()) click("#clear-board")
        settle()
    }

    browserTest("a person puts graphs together by buttons, menus, keys and drags") {
        onPage(page) {
            step("every graph can be added to a graph of the board") {
                fun add(name: String) {
                    script("arguments[0].querySelector('.add-to-graph').click()", graph(name).scrollTo().card)
                    settle()
                }
                add("Amp")
                texts(".notice p").single() shouldContain "The board has no other graph"
                pin("Volt")
                add("Amp")
                elements(".menu button").single { it.text == "Add to “Volt”" }.click()
                settle()
                lines(0) shouldBe listOf("Volt", "Amp")
                elements(".menu").size shouldBe 0
            }
            clear()
            step("graphs are pinned by a button and a key, are still there when the page is opened again, and every step can be undone") {
                element("#board").text shouldContain "Pin graphs"
                pin("Volt")
                graph("Amp").scrollTo().hover(0.5)
                press("p")
                titles() shouldBe listOf("Volt", "Amp")
                reload()
                titles() shouldBe listOf("Volt", "Amp")
                script("scrollTo(0, 0)")
                settle()
                pin("Volt")
                titles() shouldBe listOf("Amp")
                act { keyDown(Keys.CONTROL).sendKeys("z").keyUp(Keys.CONTROL) }
                titles() shouldBe listOf("Volt", "Amp")
                click("#redo")
                titles() shouldBe listOf("Amp")
                click("#clear-board")
                titles() shouldBe emptyList()
                click("#undo")
                titles() shouldBe listOf("Amp")
            }
            clear()
            step("a title is dragged between graphs, or onto a graph, which then draws both with an axis for each unit") {
                for (name in listOf("Volt", "Amp", "Speed")) pin(name)
                script("scrollTo(0, 0)")
                settle()
                dragTitle(2, 0, 0.05)
                titles() shouldBe listOf("Speed", "Volt", "Amp")
                dragTitle(1, 0, 0.5)
                titles() shouldBe listOf("Speed", "Amp")
                lines(0) shouldBe listOf("Speed", "Volt")
                texts("#board .board-graph .legend .unit").filter { it.isNotEmpty() } shouldContain "V, right"
                // The legend has the unit of each line, so the title has none.
                number("return document.querySelectorAll('#board .board-graph')[0].querySelectorAll('.graph-head > .unit').length") shouldBe 0.0
                keepScreenshot("board-axes")
                graph("Speed").pixelsOfLine(0) shouldBeGreaterThan 300
                graph("Speed").pixelsOfLine(1) shouldBeGreaterThan 300
                press(Keys.ESCAPE)
                titles() shouldBe listOf("Speed", "Amp")
            }
            clear()
            step("the keyboard alone opens a menu, moves graphs, changes their height, and joins them") {
                for (name in listOf("Volt", "Amp")) pin(name)
                focusGraph(1)
                act { keyDown(Keys.ALT).sendKeys(Keys.ARROW_UP).keyUp(Keys.ALT) }
                titles() shouldBe listOf("Amp", "Volt")
                val before = number("return document.querySelector('#board .plot').clientHeight")
                press("h")
                number("return document.querySelector('#board .plot').clientHeight") shouldBe before * 2
                script("document.querySelectorAll('#board .graph-menu')[1].focus()")
                press(Keys.ENTER)
                script("return document.activeElement.textContent") shouldBe "Move up"
                press(Keys.ARROW_UP)
                script("return document.activeElement.textContent") shouldBe "Remove this graph"
                press(Keys.ESCAPE)
                elements("#board .menu").size shouldBe 0
                script("return document.activeElement.className") as String shouldContain "graph-menu"
                choose(1, "Add to “Amp”")
                lines(0) shouldBe listOf("Amp", "Volt")
                focusGraph(0)
                press("p")
                titles() shouldBe emptyList()
                script("return document.activeElement.id") shouldBe "add-topics"
            }
            clear()
            step("any topic is added by its name; states have lanes below their numbers, and an XY plot is a new graph") {
                click("#add-topics")
                element("#topic-search").sendKeys("vol")
                texts(".topic-list bdi:first-child") shouldBe listOf("Volt")
                click(".topic-list button")
                press(Keys.ESCAPE)
                titles() shouldBe listOf("Volt")
                choose(0, "Add topics")
                element("#topic-search").sendKeys("mode")
                click(".topic-list button")
                press(Keys.ESCAPE)
                elements("#board .board-graph").size shouldBe 1
                elements("#board [data-kind='states']").size shouldBe 1
                choose(0, "Add topics")
                element("#topic-search").sendKeys("volt over amp")
                texts(".topic-list button") shouldBe emptyList()
                // The first press empties the search.
                press(Keys.ESCAPE)
                press(Keys.ESCAPE)
                click("#add-topics")
                element("#topic-search").sendKeys("volt over amp")
                texts(".topic-list button") shouldBe listOf("Volt over Amp")
                click(".topic-list button")
                element(".topic-list button").getDomAttribute("aria-pressed") shouldBe "true"
                press(Keys.ESCAPE)
                titles().last() shouldBe "Volt over Amp"
            }
            clear()
            step("a hidden line and fixed limits of y are stored with the board") {
                for (name in listOf("Volt", "Other")) pin(name)
                choose(1, "Add to “Volt”")
                val legend = elements("#board .legend-entry")
                legend[1].click()
                settle()
                choose(0, "Fix the y limits")
                elements("#board .reset-y").first().isDisplayed shouldBe true
                reload()
                elements("#board .legend-entry")[1].getDomAttribute("aria-pressed") shouldBe "false"
                elements("#board .reset-y").first().isDisplayed shouldBe true
                click("#board .reset-y")
                elements("#board .reset-y").first().isDisplayed shouldBe false
            }
            clear()
            step("a graph of the page that is dragged onto another one puts both on the board") {
                val target = graph("Amp").frame
                val source = script(
                    "const b = arguments[0].querySelector('.graph-title').getBoundingClientRect(); return [b.x + 9, b.y + 9].map(Math.round)",
                    graph("Volt").card,
                ) as List<*>
                val (x, y) = source.map { (it as Number).toInt() }
                val (toX, toY) = target.at(0.5)
                act { mouseTo(x, y).mouseDown().mouseTo(x + 8, y + 8).mouseTo(toX, toY).mouseUp() }
                lines(0) shouldBe listOf("Amp", "Volt")
            }
        }
    }

    browserTest("a pin moves the graphs of evidence to the board, which fits each screen") {
        onPage(TestPages.ofSample("qualification-42.bag", PageAdditions(rules = RuleSet.BUILT_IN))) {
            step("a pin moves the graphs of evidence to the board, and Escape ends a drag") {
                click("#clear-board")
                press("n")
                val shown = texts("#evidence .graph-title")
                shown.size shouldBeGreaterThan 0
                click("#keep-evidence")
                titles() shouldBe shown
                texts("#evidence .graph-title") shouldBe emptyList()
                val (x, y) = graph(elements("#board .graph").first().getDomAttribute("data-name")!!).frame.at(0.5)
                val title = element("#board .graph-title").location
                val scrolled = number("return scrollY").toInt()
                act { mouseTo(title.x + 9, title.y - scrolled + 9).mouseDown().mouseTo(x, y).mouseTo(x, y + 500) }
                press(Keys.ESCAPE)
                act { mouseUp() }
                elements(".drag-ghost").size shouldBe 0
                titles() shouldBe shown
            }
            for (screen in listOf(Screen(1366, 768), Screen.PHONE.copy(isDark = true))) {
                step("a board with two axes, a menu and evidence fits ${screen.width}×${screen.height}") {
                    clear()
                    show(screen)
                    script("location.hash = '#t=93.7&x=88:98&board=System/Battery+Voltage,PDP/Total+Current;System/Enabled'")
                    settle()
                    keepScreenshot("board-${screen.width}")
                    click("#board .graph-menu")
                    keepScreenshot("board-menu-${screen.width}")
                    press(Keys.ESCAPE)
                    val before = titles().size
                    click(".incident .pin")
                    titles().size shouldBeGreaterThan before
                    keepScreenshot("board-pinned-${screen.width}")
                    // A notice covers the lower edge for some seconds.
                    script("document.getElementById('add-topics').scrollIntoView({ block: 'center' })")
                    click("#add-topics")
                    keepScreenshot("board-topics-${screen.width}")
                    number("return document.documentElement.scrollWidth - innerWidth") shouldBeLessThanOrEqual 0.0
                    press(Keys.ESCAPE)
                }
            }
        }
    }
})
