package badlog.page

import badlog.core.bag.BagTopic
import badlog.protocol.PageAdditions
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists

/** The two ways to bring a board from one page to another: a link, and a layout file. */
@Tags("InCheck")
internal class PageLinkSpec : PageSpec({
    val bag by lazy {
        bagOf(listOf(TIME, BagTopic("Voltage", "V"), BagTopic("Current", "A")), 1001) { row, column ->
            if (column == 0) row / 100.0 else row * column
        }
    }
    val page by lazy { TestPages.of(bag) }

    fun OpenPage.titles() = texts("#board .graph-title")

    fun OpenPage.notice() = texts(".notice p").single()

    /** Drops a file with this [name] and [text], and waits until the page shows the sentence [says]. */
    fun OpenPage.drop(name: String, text: String, says: String) {
        script(
            """
            const data = new DataTransfer()
            data.items.add(new File([arguments[1]], arguments[0], {type: 'application/json'}))
            document.body.dispatchEvent(new DragEvent('drop', {dataTransfer: data, bubbles: true, cancelable: true}))
            """.trimIndent(),
            name,
            text,
        )
        await("“$says”") { notice() == says }
        settle()
    }

    browserTest("a link brings moment, range, board and formulas to another page; a layout brings a board") {
        onPage(page) {
            step("a copied link contains moment, range, board and formulas, and shows them on another page") {
                press("f")
                press("Power [W] = Voltage * Current", Keys.ENTER)
                await("the formula’s graph") { "Power" in graphNames }
                for (name in listOf("Current", "Power")) script("arguments[0].querySelector('.pin').click()", graph(name).card)
                graph("Current").scrollTo().drag(0.2, 0.6)
                script("location.hash = '#t=4'")
                settle()
                script("Object.defineProperty(navigator, 'clipboard', {value: {writeText: async text => { window.copied = text }}})")
                click("#copy-link")
                await("the notice") { notice() == "Link copied." }
                val link = "#" + (script("return window.copied") as String).substringAfter('#')
                link shouldContain "t=4"
                link shouldContain "x="
                link shouldContain "board=Current;Power"
                link shouldContain "f=Power+"
                startOver()
                titles() shouldBe emptyList()
                script("location.hash = arguments[0]", link)
                // Formulas may take several slices, and the rest of the link waits for them.
                await("the board of the link") { titles() == listOf("Current", "Power") }
                await("its moment") { texts(".cursor-readout").single() == "4.0000 s" }
                visibleRange.start shouldBe (link.substringAfter("x=").substringBefore(':').toDouble() plusOrMinus 0.001)
                reload()
                titles() shouldBe listOf("Current", "Power")
                val remembered = "return Object.keys(localStorage).filter(key => /:(formulas|board):/.test(key)).map(key => localStorage[key]).join()"
                script(remembered) shouldBe ""
                click("#undo")
                titles() shouldBe emptyList()
                reload()
                titles() shouldBe emptyList()
                // Formulas that use them may be the reader's own by now.
                script(remembered) as String shouldContain "Power [W] = Voltage * Current"
                startOver()
                script("location.hash = arguments[0]", link)
                settle()
                script("history.replaceState(null, '', location.pathname)")
                reload()
                graphNames shouldBe listOf("Voltage", "Current")
            }
            startOver()
            step("the keyboard stays on the button that copies a link, also where a page may not use the clipboard") {
                script("Object.defineProperty(navigator, 'clipboard', {value: null})")
                click("#copy-link")
                await("the notice") { notice() == "Link copied." || notice() == "Copy the link from the address bar." }
                script("return document.activeElement.closest('#copy-link') !== null") shouldBe true
            }
            startOver()
            step("a layout is saved, and applied when it is dropped on the page") {
                script("arguments[0].querySelector('.pin').click()", graph("Current").card)
                settle()
                val file = Chromium.downloads.resolve("test.bag.badlog-layout.json")
                file.deleteIfExists()
                click("#download-layout")
                await("the download") { file.exists() && !Path.of("$file.crdownload").exists() }
                val layout = Files.readString(file)
                startOver()
                drop("photo.json", "{}", says = "photo.json is not a layout, or is damaged; select a file that badlog has saved.")
                titles() shouldBe emptyList()
                drop("mine.badlog-layout.json", layout, says = "Opened the layout.")
                titles() shouldBe listOf("Current")
            }
            startOver()
            step("the first graphs drawn after a link are those in it") {
                val whatIsDrawn = """
                    const mark = performance.mark
                    performance.mark = name => {
                        window.first = [...document.querySelectorAll('.graph')].filter(e => e.querySelector('canvas')).map(e => e.dataset.name)
                        return mark.call(performance, name)
                    }
                """
                runFirst(whatIsDrawn)
                script("location.hash = '#board=Current'")
                reload()
                script("return window.first[0]") shouldBe "Current"
            }
        }
    }

    browserTest("a page begins with its exported layout, until the reader has another board") {
        val layout = """{"badlog-layout":1,"graphs":[{"title":"Power","lines":["Power","Current"]}],"formulas":["Power [W] = Voltage * Current"]}"""
        onPage(TestPages.of(bag, additions = PageAdditions(layout = layout))) {
            titles() shouldBe listOf("Power")
            texts("#board .legend .unit").filter { it.isNotEmpty() } shouldBe listOf("W", "A, right")
            click("#clear-board")
            reload()
            titles() shouldBe emptyList()
        }
    }
})
