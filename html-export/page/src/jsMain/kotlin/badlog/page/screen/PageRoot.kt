package badlog.page.screen

import badlog.page.dom.PageEvents
import badlog.page.dom.focusInPlace
import kotlinx.browser.document
import org.w3c.dom.HTMLElement

/** The [root] of the page. It shows either a log, the progress of reading, or the reason why a log cannot be shown. */
internal class PageRoot(private val root: HTMLElement) {
    /** Empties the page, and ends the listeners and the work of the previous content. */
    fun clear() {
        PageEvents.end()
        root.textContent = ""
    }

    /** Adds [element] to the cleared page. */
    fun show(element: HTMLElement) {
        root.appendChild(element)
    }

    /** Moves the keyboard's focus to the content, unless it is already there. */
    fun focus() {
        if (document.activeElement !== document.body) return
        root.tabIndex = -1
        root.focusInPlace()
    }

    /** Shows [element] instead of the previous content. */
    fun showAlone(element: HTMLElement) {
        clear()
        show(element)
    }

    /** Shows the reason why there is nothing to show; [tools] offer other actions. */
    fun fail(title: String, explanation: String, tools: HTMLElement? = null) {
        setPageState("failed")
        showAlone(failureScreen(title, explanation, tools))
    }

    /** Shows [problem], an unexpected exception. */
    fun failUnexpectedly(problem: Throwable, tools: HTMLElement? = null) {
        console.error(problem)
        val reason = problem.message ?: problem.toString()
        fail("Something went wrong", "$reason. Report it with the file, if you may share it.", tools)
    }

    /** Runs [work]; shows the reason if it fails. */
    fun guarded(work: () -> Unit) = try {
        work()
    } catch (problem: Throwable) {
        failUnexpectedly(problem)
    }
}
