package badlog.page.screen

import kotlinx.browser.document

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
