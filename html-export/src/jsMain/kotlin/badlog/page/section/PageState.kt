package badlog.page.section

import kotlinx.browser.document

/** Says in the page, for whoever drives it, how far the rules are: `done` or `failed`. */
internal fun setRulesState(state: String) {
    document.documentElement?.setAttribute("data-rules", state)
}

/** Says in the page, for whoever drives it, how far it is. */
internal fun setPageState(state: String) {
    document.documentElement?.setAttribute("data-state", state)
}
