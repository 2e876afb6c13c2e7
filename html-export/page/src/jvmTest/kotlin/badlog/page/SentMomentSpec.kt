package badlog.page

import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith

/** A moment that a person sends to others. */
@Tags("InCheck")
internal class SentMomentSpec : PageSpec({
    browserTest("a moment is sent by the system's dialog, otherwise copied, otherwise saved") {
        onPage(TestPages.ofSample("qualification-42.bag", PageAdditions(rules = RuleSet.BUILT_IN))) {
            press("n")
            await("the evidence") { element("#evidence").isDisplayed }
            script("navigator.canShare = () => true; navigator.share = async data => { window.sent = data }")
            click("#send-moment")
            await("what was sent") { script("return window.sent !== undefined") == true }
            (script("return window.sent.text") as String) shouldStartWith
                "Mill Creek Regional Qualification 42: Likely cause: the robot drew more than its battery gives."
            script("return window.sent.files[0].type") shouldBe "image/png"
            number("return window.sent.files[0].size").toInt() shouldBeGreaterThan 10_000

            // After a reader has closed the dialog, nothing else happens.
            script(
                "navigator.share = () => { window.asked = true; return Promise.reject(new DOMException('', 'AbortError')) };" +
                    "navigator.clipboard.write = async items => { window.copied = items }",
            )
            click("#send-moment")
            await("the dialog") { script("return window.asked === true") == true }
            settle()
            script("return window.copied ?? null") shouldBe null

            script("navigator.canShare = undefined")
            click("#send-moment")
            await("the copy") { script("return window.copied !== undefined") == true }
            script("return window.copied[0].types.join(' ')") shouldBe "image/png text/plain"
            await("the sentence") { texts(".notice p").single().startsWith("Picture and text copied") }

            script("navigator.clipboard.write = () => Promise.reject(new Error('no'))")
            saved("qualification-42 moment.png") { click("#send-moment") }.size shouldBeGreaterThan 10_000
        }
    }
})
