package badlog.page

import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith

/** A moment that a person sends to others. */
internal class SentMomentSpec : PageSpec({
    val page by lazy { TestPages.ofSample("qualification-42.bag", PageAdditions(rules = RuleSet.BUILT_IN)) }
    val sentence = "Mill Creek Regional Qualification 42: Likely cause: the robot drew more than its battery gives."

    /** Opens the page at its worst incident, in a browser that [has] these abilities. */
    fun onIncident(has: String, test: OpenPage.() -> Unit) = onPage(page, script = has) {
        press("n")
        await("the evidence") { element("#evidence").isDisplayed }
        click("#send-moment")
        test()
    }

    browserTest("where the system has a dialog for it, that gets a picture and the sentences of the incident") {
        onIncident("navigator.canShare = () => true; navigator.share = async data => { window.sent = data }") {
            await("what was sent") { script("return window.sent !== undefined") == true }
            (script("return window.sent.text") as String) shouldStartWith sentence
            script("return window.sent.files[0].type") shouldBe "image/png"
            number("return window.sent.files[0].size").toInt() shouldBeGreaterThan 10_000
        }
    }

    browserTest("a dialog that was closed is the end of it") {
        val closed = "navigator.canShare = () => true; navigator.share = () => { window.asked = true; return Promise.reject(new DOMException('', 'AbortError')) };" +
            "navigator.clipboard.write = () => { window.copied = true }"
        onIncident(closed) {
            await("the dialog") { script("return window.asked === true") == true }
            settle()
            script("return window.copied ?? null") shouldBe null
        }
    }

    browserTest("otherwise picture and text are copied") {
        onIncident("navigator.canShare = undefined; navigator.clipboard.write = async items => { window.copied = items }") {
            await("the copy") { script("return window.copied !== undefined") == true }
            script("return window.copied[0].types.join(' ')") shouldBe "image/png text/plain"
            await("the sentence") { texts(".notice p").single().startsWith("Picture and text copied") }
        }
    }

    browserTest("or the picture is saved, where a page may not even copy") {
        onPage(page, script = "navigator.canShare = undefined; navigator.clipboard.write = () => Promise.reject(new Error('no'))") {
            press("n")
            await("the evidence") { element("#evidence").isDisplayed }
            saved("qualification-42 moment.png") { click("#send-moment") }.size shouldBeGreaterThan 10_000
        }
    }
})
