package badlog.window.screen

import io.kotest.core.test.Enabled
import java.awt.GraphicsEnvironment

/** Whether there is a screen, real or virtual, to open a window on. The build starts a virtual one if possible. */
internal val needsDisplay: Enabled = when {
    !GraphicsEnvironment.isHeadless() -> Enabled.enabled
    System.getenv("BADLOG_DISPLAY") == "required" -> error("BADLOG_DISPLAY asks for a screen, but there is none; is Xvfb there?")
    else -> Enabled.disabled("Window tests are skipped: there is no screen, and no Xvfb to make one.")
}
