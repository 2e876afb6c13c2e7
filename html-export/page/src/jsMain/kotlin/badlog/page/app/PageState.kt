package badlog.page.app

import kotlinx.browser.document

/** Records in the page, for programs that control it, the state of the rules: `done` or `failed`. */
internal fun setRulesState(state: String) {
    document.documentElement?.setAttribute("data-rules", state)
}

/** Records in the page, for programs that control it, the state of loading. */
internal fun setPageState(state: String) {
    document.documentElement?.setAttribute("data-state", state)
}
