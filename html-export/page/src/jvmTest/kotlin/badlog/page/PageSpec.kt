package badlog.page

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import java.nio.file.Path

/** Tests of exported pages in a real browser; each skips, saying why, where there is none. */
internal abstract class PageSpec(body: PageSpec.() -> Unit) : FunSpec() {
    init {
        body()
    }

    /** A test in the browser. */
    fun browserTest(name: String, test: suspend () -> Unit) {
        test(name).config(enabledOrReasonIf = { Chromium.enabled }) { test() }
    }

    /**
     * Opens [page] on a [screen] of its own, waits until it shows what it can, and does [test]. Whatever is tested, a
     * page writes nothing to the console and asks nothing of the network.
     *
     * @param script runs in the page before its own script does.
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
     * Opens the page at [address], which a server has, waits for its [state], and does [test]. Whatever is tested, it asks no other server, and
     * writes nothing to the console but what [says] names: browsers report answers that are refusals.
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
