package badlog.web

import java.io.File
import java.util.function.BooleanSupplier

/** Options of [LogServer.start]. Everything about the robot comes from WPILib, of any season, unless a supplier is set here. */
public class LogServerOptions {
    private val mode = RobotMode.find(LogServerOptions::class.java.classLoader)

    /**
     * The folders of the logs to show, including their subfolders. Default: empty, which means the folders to which badlog and WPILib log:
     * the USB stick's, the robot's own, and `logs` in the working directory. Folders that do not exist yet are shown once they do.
     */
    public var folders: List<File> = emptyList()

    /**
     * Whether to answer even while the robot is enabled or connected to the field. Default: false, so that nothing but the robot's program
     * runs in a match.
     */
    public var isAlwaysOpen: Boolean = false

    /** Whether the robot is enabled. Called from the server's threads. Default without WPILib: never. */
    public var isEnabled: BooleanSupplier = mode.isEnabled

    /** Whether the robot is connected to the field. Called from the server's threads. Default without WPILib: never. */
    public var isFieldAttached: BooleanSupplier = mode.isFieldAttached

    /** The bytes per second that all downloads together may send. */
    internal var bytesPerSecond = 1_000_000L

    /** The clock of the downloads. */
    internal var clock = Clock()
}
