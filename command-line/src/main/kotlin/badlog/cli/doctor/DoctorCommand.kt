package badlog.cli.doctor

import badlog.cli.command.SubCommand
import badlog.cli.command.Task
import badlog.cli.computer.Computer
import badlog.cli.fetch.Robots
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.arguments.optional

internal class DoctorCommand(private val computer: Computer, private val robots: Robots) :
    SubCommand(
        "doctor",
        "Shows what badlog finds on this computer.",
        "Java, the browser, the window, CTRE's owlet, the folders that badlog uses and, if you name one, whether a robot answers. What " +
            "is missing is reported with what to do about it.",
    ) {
    private val robot by argument("ROBOT").optional().help("A team's number, or an address, such as 10.10.14.2.")

    override val examples: List<String> = listOf("doctor", "doctor 1014")

    override val words: List<String> get() = listOfNotNull(robot)

    override fun makeTask(): Task {
        val addresses = try {
            robot?.let { robots.addressesOf(it, null) }
        } catch (e: IllegalArgumentException) {
            throw UsageError(e.message.orEmpty())
        }
        return DoctorTask(Checkup(computer, addresses, robots.patience.connect), isJson)
    }
}
