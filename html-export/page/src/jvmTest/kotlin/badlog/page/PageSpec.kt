package badlog.page

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import java.nio.file.Path

/** Tests of exported pages in a real browser; each is skipped with a reason if there is none. */
internal abstract class PageSpec(body: PageSpec.() -> Unit) : FunSpec() {
    init {
        body()
    }

    /** Adds a test that needs the browser. */
    fun browserTest(name: String, test: suspend () -> Unit) {
        test(name).config(enabledOrReasonIf = { Chromium.enabled }) { test() }
    }

    /** Runs [test], a part of a test that shows [what]. A failure names it, because a test may have many steps. */
    fun step(what: String, test: () -> Unit) {
        try {
            test()
        } catch (e: Throwable) {
            throw AssertionError("Step “$what”: ${e.message}", e)
        }
    }

    /**
     * Opens [page] on its own [screen], waits for its state, and runs [test]. Every page must write nothing to the console and request
     * nothing from the network.
     *
     * @param script runs in the page before its own script.
     */
    fun onPage(
        page: Path,
        screen: Screen = Screen.WIDE,
        script: String? = null,
        state: String = "ready",
        test: OpenPage.() -> Unit,
    ) {
        OpenPage.open(page, screen, script).use { open ->
            open.awaitState(state)
            open.test()
            open.passTime()
            open.consoleMessages().shouldBeEmpty()
            open.requests().filterNot { it.startsWith("file:") || it.startsWith("blob:") || it.startsWith("data:") }
                .shouldBeEmpty()
        }
    }

    /**
     * Opens the page at [address] on a server, waits for its [state], and runs [test]. It must request nothing from other servers, and
     * write nothing to the console except messages with the text [says], because browsers report refusals.
     */
    fun onServedPage(
        address: String,
        screen: Screen = Screen.WIDE,
        state: String = "empty",
        says: List<String> = emptyList(),
        test: OpenPage.() -> Unit,
    ) {
        OpenPage.open(address, screen, script = null).use { open ->
            open.awaitState(state)
            open.test()
            open.passTime()
            open.consoleMessages().filterNot { message -> says.any { it in message } }.shouldBeEmpty()
            val server = address.substringBeforeLast('/')
            open.requests().filterNot { it.startsWith(server) || it.startsWith("blob:") || it.startsWith("data:") }.shouldBeEmpty()
        }
    }
}
