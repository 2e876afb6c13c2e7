package badlog.page.screen

import badlog.page.dom.PageEvents
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.focusInPlace
import kotlinx.browser.document
import kotlinx.browser.window
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

/** Records in the page, for programs that control it, the state of the rules: `done` or `failed`. */
internal fun setRulesState(state: String) {
    document.documentElement?.setAttribute("data-rules", state)
}

/** Records in the page, for programs that control it, its state: `loading`, `ready`, `failed`, or `empty` without a log. */
internal fun setPageState(state: String) {
    // The rules of the previous log no longer matter.
    if (state != "ready") document.documentElement?.removeAttribute("data-rules")
    document.documentElement?.setAttribute("data-state", state)
}

/** Whether a log is being opened, or rules run over it. */
internal val isPageBusy: Boolean
    get() = document.documentElement?.run {
        getAttribute("data-state") == "loading" || (getAttribute("data-state") == "ready" && getAttribute("data-rules") == null)
    } ?: true

/** The screen shown while the log [name] is being read; [cancel] stops reading, if that is possible. */
internal class LoadingScreen(name: String, cancel: (() -> Unit)? = null) {
    private lateinit var bar: HTMLElement

    val element: HTMLElement = element("div", "screen loading") {
        setAttribute("role", "status")
        add("p", "screen-title", "Reading $name…")
        add("div", "progress") { bar = add("div", "progress-bar") }
        cancel?.let { addButton("", "Cancel", onClick = it).id = "cancel" }
    }

    init {
        // Most logs are loaded before anyone could read this.
        window.setTimeout({ element.classList.add("is-slow") }, PATIENCE_MILLISECONDS)
    }

    /** Shows the [share] of the work that is done, 0 to 1. */
    fun show(share: Double) {
        bar.style.width = "${share * 100}%"
    }
}

/** Returns the screen shown instead of a log that cannot be shown. */
internal fun failureScreen(title: String, explanation: String, tools: HTMLElement? = null): HTMLElement = element("div", "screen failure") {
    setAttribute("role", "alert")
    add("p", "screen-title", title)
    add("p", "screen-text", explanation)
    if (tools != null) appendChild(tools)
}

private const val PATIENCE_MILLISECONDS = 300
