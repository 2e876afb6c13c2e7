package badlog.cli.doctor

import badlog.cli.command.ExitCode
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.console.Spelling
import badlog.cli.text.jsonOf
import badlog.cli.text.wrapped
import kotlinx.serialization.Serializable

/** Shows the findings of [checkup]. If something essential is missing, it ends with [ExitCode.SALVAGED]. */
internal class DoctorTask(private val checkup: Checkup, private val isJson: Boolean) : Task {
    override fun run(console: Console): ExitCode {
        val findings = checkup.findings()
        if (isJson) {
            console.say(
                Spelling.ascii(
                    jsonOf(
                        DoctorJson(
                            "doctor",
                            findings.map {
                                CheckJson(it.name, it.state.word, it.text)
                            },
                        ),
                    ).toString(),
                ),
            )
        } else {
            for (finding in findings) {
                console.say(
                    wrapped("  ${finding.state.word.padEnd(COLUMN)}${finding.name.padEnd(COLUMN)}", finding.text),
                )
            }
        }
        return if (findings.any { it.state == CheckState.ERROR }) ExitCode.SALVAGED else ExitCode.WHOLE
    }
}

@Serializable
private class DoctorJson(private val command: String, private val checks: List<CheckJson>)

@Serializable
private class CheckJson(private val name: String, private val status: String, private val found: String)

private const val COLUMN = 10
