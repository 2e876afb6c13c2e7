package badlog.window.waiting

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import badlog.window.app.Viewer

/**
 * Waits until [condition] holds, and what the window’s thread is doing then is done: it may have changed only a part of the state. Compose
 * waits a second by itself, which a busy machine exceeds.
 */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.waitFor(condition: () -> Boolean) {
    waitUntil(timeoutMillis = 60_000, condition = condition)
    runOnUiThread { }
}

/** Waits until [viewer] says something that has [text] in it. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.waitForNotice(viewer: Viewer, text: String) = waitFor { viewer.notices.all.any { text in it.text } }
