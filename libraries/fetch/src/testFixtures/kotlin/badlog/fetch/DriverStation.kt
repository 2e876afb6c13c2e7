package badlog.fetch

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.networktables.replay.ReplayOptions
import badlog.networktables.replay.ReplayServer
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.withSignals

/** Enables and disables a robot. Its NetworkTables answer at [port] of this computer. */
class DriverStation : AutoCloseable {
    private val server = ReplayServer(view(), ReplayOptions(port = 0)).apply { open() }

    /** The port of the robot's NetworkTables. */
    val port: Int get() = server.port

    /** Whether the robot is enabled; disabled at first. */
    var isEnabled: Boolean = false
        set(value) {
            field = value
            server.seek(if (value) 1.0 else 0.0)
        }

    override fun close() = server.close()

    private fun view(): LogView {
        val parser = BagParser()
        parser.accept("""{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Enabled"}],"values":[]}${"\n"}Time,Enabled${"\n"}0,false${"\n"}1,true${"\n"}""".encodeToByteArray())
        return LogView.of(parser.finish()).withSignals(RuleSet.BUILT_IN.signals, "robot.bag")
    }
}
