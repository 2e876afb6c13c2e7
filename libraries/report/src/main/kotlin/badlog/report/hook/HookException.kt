package badlog.report.hook

import java.io.IOException

/**
 * A hook gave nothing that can be used. The message says what went wrong and what to do, with the last that the program wrote to its
 * standard error.
 */
public class HookException internal constructor(override val message: String, cause: Throwable? = null) : IOException(message, cause)
