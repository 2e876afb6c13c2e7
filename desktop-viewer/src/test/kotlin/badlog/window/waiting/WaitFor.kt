package badlog.window.waiting

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import badlog.window.app.Viewer

/**
 * Waits until [condition] holds, and the window’s thread has finished its current work. That work may have changed only a part of the
 * state. Compose's own wait ends after a second, which a busy machine exceeds.
 */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.waitFor(condition: () -> Boolean) {
    waitUntil(timeoutMillis = 60_000, condition = condition)
    runOnUiThread { }
}

/** Waits until a notice of [viewer] contains [text]. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.waitForNotice(viewer: Viewer, text: String) = waitFor { viewer.notices.all.any { text in it.text } }
