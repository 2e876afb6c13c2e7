package badlog.page.screen

import badlog.page.dom.PageEvents
import org.w3c.dom.HTMLElement

/** The [root] of the page, which shows one thing at a time: a log, how far it has been read, or why it cannot be shown. Never nothing. */
internal class PageRoot(private val root: HTMLElement) {
    /** Shows nothing, and ends what the page listened to for whatever was shown before. */
    fun clear() {
        PageEvents.end()
        root.textContent = ""
    }

    /** Shows [element] on the cleared page. */
    fun show(element: HTMLElement) {
        root.appendChild(element)
    }

    /** Shows [element] instead of whatever was shown before. */
    fun showAlone(element: HTMLElement) {
        clear()
        show(element)
    }

    /** Says why there is nothing to show; [tools] offer what else can be done. */
    fun fail(title: String, explanation: String, tools: HTMLElement? = null) {
        setPageState("failed")
        showAlone(failureScreen(title, explanation, tools))
    }

    /** Says that [problem] came up, which nobody expected. */
    fun failUnexpectedly(problem: Throwable, tools: HTMLElement? = null) {
        console.error(problem)
        val reason = problem.message ?: problem.toString()
        fail("Something went wrong", "$reason. Report it with the file, if you may share it.", tools)
    }

    /** Does [work], or says why it failed. */
    fun guarded(work: () -> Unit) = try {
        work()
    } catch (problem: Throwable) {
        failUnexpectedly(problem)
    }
}
