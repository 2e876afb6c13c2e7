package badlog.window.task

import java.awt.EventQueue

/**
 * Asserts that work on files and whole logs is off the window's thread, which it would block. It has an effect only in tests and in
 * development.
 */
internal fun assertOffWindow() = assert(!EventQueue.isDispatchThread()) { "A file or a whole log is worked on by the window’s thread." }
