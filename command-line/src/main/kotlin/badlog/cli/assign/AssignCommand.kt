package badlog.cli.assign

import badlog.cli.command.SubCommand
import badlog.cli.command.Task
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.types.path

internal class AssignCommand :
    SubCommand(
        "assign",
        "Names the topic that is a signal in your logs, such as the battery.",
        "badlog-signals.toml beside the log gets the name, so rules, questions and formulas use the topic in all logs of the folder. " +
            "badlog info --signals shows which topic is which signal; docs/signals.md lists all signals.",
    ) {
    private val log by argument("LOG").path().help("A log that has the topic.")
    private val signal by argument("SIGNAL").help("The signal: battery, loop time, …")
    private val topic by argument("TOPIC").help("The full name of the topic.")

    override val examples: List<String> = listOf("assign match.bag battery \"Power/My Volts\"")

    override val words: List<String> get() = listOf("$log", signal, topic)

    override fun makeTask(): Task = AssignTask(log, signal, topic, currentContext.suggestTypoCorrection, isJson)
}
