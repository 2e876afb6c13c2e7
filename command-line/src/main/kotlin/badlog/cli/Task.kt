package badlog.cli

/** What a command line asks for, once it is understood. */
internal fun interface Task {
    /** Does it. Whatever goes wrong with the logs is told and counted, never thrown. */
    fun run(console: Console): ExitCode
}
