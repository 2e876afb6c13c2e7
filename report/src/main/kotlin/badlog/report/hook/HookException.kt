package badlog.report.hook

import java.io.IOException

/**
 * A hook gave nothing that can be used. The message is one sentence: what went wrong, and what to do.
 *
 * @property errorOutput what the program wrote to its standard error, at most the last 64 KiB.
 */
public class HookException internal constructor(
    override val message: String,
    public val errorOutput: String,
    cause: Throwable? = null,
) : IOException(message, cause)
