package badlog.report.page

import badlog.files.inFolder
import badlog.page.Chromium
import badlog.page.OpenPage
import badlog.page.Screen
import badlog.page.seriousForReaders
import badlog.report.Report
import badlog.report.SAMPLES
import badlog.report.batteryBag
import badlog.report.logsIn
import badlog.report.put
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import org.openqa.selenium.By
import org.openqa.selenium.Keys
import java.nio.file.Path

/** The index of a report in a real browser; each test is skipped if there is none. */
@Tags("InCheck")
class IndexPageSpec : FunSpec({
    fun browserTest(name: String, test: (OpenPage) -> Unit, page: (Path) -> String) {
        test(name).config(enabledOrReasonIf = { Chromium.enabled }) {
            inFolder { folder ->
                val file = folder.put("index.html", page(folder))
                OpenPage.open(file, Screen.WIDE, script = null).use { open ->
                    open.settle()
                    test(open)
                    open.consoleMessages().shouldBeEmpty()
                    open.requests().filterNot { it.startsWith("file:") }.shouldBeEmpty()
                }
            }
        }
    }

    val ofSamples by lazy { reportPage(Report().over(SAMPLES)) { "${it.file.name.substringBefore('.')}.html" } }
    val samples = { _: Path -> ofSamples }

    fun OpenPage.shownItems() = elements(".match li").count { it.isDisplayed }

    /** Selects [value] in the field [name] of the filter, as a person does. */
    fun OpenPage.set(name: String, value: String) {
        val field = "document.getElementById('filter').elements[arguments[0]]"
        script("$field.value = arguments[1]; $field.dispatchEvent(new Event('input', { bubbles: true }))", name, value)
        settle()
    }

    fun OpenPage.shownMatches() = elements(".overview tbody tr").filter { it.isDisplayed }.map { it.findElement(By.tagName("th")).text }

    browserTest("matches are listed with the worst first, each with its counts and its first finding", { page ->
        page.shownMatches().take(2) shouldBe listOf("Qualification 42", "practice.bag")
        page.texts(".overview thead th").take(4) shouldBe listOf("Match", "Errors", "Warnings", "Notes")
        page.texts(".overview .first a").first() shouldBe "The robot drew more than its battery gives"
        val severities = page.texts("#log-2 .findings .severity")
        severities shouldBe severities.sortedBy { listOf("error", "warning", "note").indexOf(it) }
        page.show(Screen.PHONE)
        page.elements(".overview .first a").first().isDisplayed shouldBe true
        page.number("return document.documentElement.scrollWidth - innerWidth") shouldBeLessThanOrEqual 0.0
    }, page = samples)

    browserTest("axe-core finds nothing serious, on any screen, light and dark", { page ->
        for (screen in listOf(Screen.WIDE, Screen.PHONE.copy(isDark = true))) {
            page.show(screen)
            withClue("$screen") { page.seriousForReaders().shouldBeEmpty() }
        }
    }, page = samples)

    browserTest("a search, a severity and a type leave what fits, and say how much", { page ->
        val all = page.shownItems()
        page.click("#filter input")
        page.press("brownout")
        page.shownMatches() shouldBe listOf("Qualification 42")
        page.texts("output").single() shouldStartWith "1 of 5 matches, "
        (page.shownItems() < all) shouldBe true
        page.set("words", "")
        page.shownItems() shouldBe all
        page.set("level", "2")
        page.elements(".match li").filter { it.isDisplayed }.all { it.getDomAttribute("class") == "error" } shouldBe true
        page.shownMatches().size shouldBe 2
    }, page = samples)

    browserTest("matches are ordered by event and match, and a filter hides the titles of others", { page ->
        page.shownMatches() shouldBe listOf("Playoff 1", "Qualification 1")
        page.set("order", "event")
        page.shownMatches() shouldBe listOf("Mill Creek · Qualification", "Qualification 1", "Mill Creek · Playoff", "Playoff 1")
        page.set("type", "Playoff")
        page.shownMatches() shouldBe listOf("Mill Creek · Playoff", "Playoff 1")
        page.texts("output").single() shouldStartWith "1 of 2 matches"
        page.set("type", "")
        page.set("order", "")
        page.shownMatches() shouldBe listOf("Playoff 1", "Qualification 1")
    }) { folder ->
        folder.put("logs/1.bag", batteryBag(6.0, 6.0, 6.0).replace("Qualification", "Playoff"))
        folder.put("logs/2.bag", batteryBag(6.0, 6.0, 6.0))
        reportPage(Report().over(logsIn(folder.resolve("logs"))))
    }

    browserTest("nothing is wider than the screen, and no word is broken", { page ->
        for (screen in listOf(Screen.WIDE, Screen.PHONE, Screen.PHONE.copy(width = 320, isDark = true))) {
            page.show(screen)
            page.number("return document.documentElement.scrollWidth") shouldBeLessThanOrEqual screen.width.toDouble()
            page.number("return Math.max(...[...document.querySelectorAll('.severity')].map(e => e.getClientRects().length))") shouldBe 1.0
            page.keepScreenshot("index-${screen.width}")
        }
    }, page = samples)

    browserTest("a screen reader finds main, headings, a table with headers and named parts, and a key skips the filter", { page ->
        page.elements("main").size shouldBe 1
        page.texts("h1, h2") shouldBe listOf("Report: Mill Creek Regional", "Matches", "Batteries", "Trends", "Incidents and findings", "Skipped")
        page.elements(".overview th[scope]").size shouldBe page.elements(".overview th").size
        page.elements("article[aria-labelledby]").size shouldBe page.elements("article").size
        page.elements("input, select").all { it.accessibleName.orEmpty().isNotEmpty() } shouldBe true
        page.press(Keys.TAB)
        page.script("return document.activeElement.textContent") shouldBe "Skip to the matches"
    }, page = samples)

    browserTest("an incident is above the findings of its match, and links to the moment of each sentence", { page ->
        val incident = page.element("#log-2 .incidents li")
        incident.text.orEmpty() shouldContain "Likely cause: the robot drew more than its battery gives."
        val links = incident.findElements(By.tagName("a")).map { it.getDomAttribute("href") }
        links shouldContain "./qualification-42.html#t=93.709649&finding=Browned+out;System/Browned+Out"
    }, page = samples)
})
