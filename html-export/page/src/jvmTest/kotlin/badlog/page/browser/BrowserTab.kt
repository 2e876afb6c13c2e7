package badlog.page.browser

import badlog.core.waiting.eventually
import org.openqa.selenium.interactions.Sequence

/** A tab of a browser, with the operations that all drivers have in common. */
internal interface BrowserTab : AutoCloseable {
    /** Loads the page at [address], and returns once its document is loaded. */
    fun open(address: String)

    /** Returns the result of a JavaScript [expression], or of its promise, as text. */
    fun evaluate(expression: String): String

    /** Performs the moves, presses and keys of all [sequences] at the same time. */
    fun perform(sequences: List<Sequence>)

    /** Returns a screenshot of the tab, as PNG. */
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

/** Waits until [state] holds. Some browsers handle an action later than their drivers report, so [settle] would not suffice. */
internal fun BrowserTab.awaitThat(state: () -> Unit) = eventually("what the cause says") {
    state()
    true
}

/** Waits until the effect of the last action is on the screen. */
internal fun BrowserTab.settle() {
    evaluate("new Promise(done => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done)))))")
}

private const val MAX_TEXT = 1000
