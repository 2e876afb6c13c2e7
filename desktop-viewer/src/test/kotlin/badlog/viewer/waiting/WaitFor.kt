package badlog.viewer.waiting

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import badlog.viewer.app.Viewer

/** Waits until [condition] holds. Compose waits a second by itself, which a busy machine exceeds. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.waitFor(condition: () -> Boolean) = waitUntil(timeoutMillis = 60_000, condition = condition)

/** Waits until [viewer] says something that has [text] in it. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.waitForNotice(viewer: Viewer, text: String) = waitFor { viewer.notices.all.any { text in it.text } }
