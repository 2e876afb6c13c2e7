package badlog.page.browser

import badlog.core.waiting.eventually
import org.openqa.selenium.interactions.Sequence

/** A tab of a browser, by what its driver and those of the other browsers have in common. */
internal interface BrowserTab : AutoCloseable {
    /** Loads the page at [address], and comes back when its document is there. */
    fun open(address: String)

    /** What a JavaScript [expression], or what it promises, is as text. */
    fun evaluate(expression: String): String

    /** Moves, presses and types all [sequences] at the same time. */
    fun perform(sequences: List<Sequence>)

    /** What the tab shows, as PNG. */
    fun screenshot(): ByteArray
}

/** Waits until [expression] is true on the page. */
internal fun BrowserTab.await(expression: String) {
    try {
        eventually(expression) { evaluate(expression) == "true" }
    } catch (e: AssertionError) {
        throw AssertionError("${e.message} The page shows:\n" + evaluate("document.body.innerText").take(MAX_TEXT), e)
    }
}

/** Waits until [state] holds: where a browser handles an action later than its driver says, [settle] would not be enough. */
internal fun BrowserTab.awaitThat(state: () -> Unit) = eventually("what the cause says") {
    state()
    true
}

/** Waits until what was just done is on the screen. */
internal fun BrowserTab.settle() {
    evaluate("new Promise(done => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done)))))")
}

private const val MAX_TEXT = 1000
