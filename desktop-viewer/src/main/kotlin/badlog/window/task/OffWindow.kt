package badlog.window.task

import java.awt.EventQueue

/** Work on files and whole logs belongs off the window's thread, which would stand still meanwhile; checked in tests and in development. */
internal fun assertOffWindow() = assert(!EventQueue.isDispatchThread()) { "A file or a whole log is worked on by the window’s thread." }
