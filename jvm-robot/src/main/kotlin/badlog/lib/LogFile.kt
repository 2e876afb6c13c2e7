package badlog.lib

import java.io.File
import java.io.IOException

/** The file of a log. */
internal class LogFile(path: File, val output: BagOutput) {
    /** Where it is; changes when it is renamed. */
    @Volatile
    var path: File = path
        private set

    /** Whether it is there no more, though it can still be written to. */
    @Volatile
    var isMissing: Boolean = false

    /** Gives it another name; false, and nothing changed, if that fails. */
    fun rename(to: File): Boolean = path.renameTo(to).also { if (it) path = to }

    /** Closes it; said if that fails, for a disk may be gone by then. */
    fun close(faults: Faults) {
        try {
            output.close()
        } catch (failure: IOException) {
            faults.sayOnce("close") {
                "The log $path could not be closed: ${describe(failure)}. Its end may be missing."
            }
        }
    }

    /** Closes and deletes it, because its log was closed before it began. */
    fun discard(faults: Faults) {
        close(faults)
        // Not a device or a pipe.
        if (path.isFile) path.delete()
    }

    companion object {
        /** Creates or empties the file at [path]; null, said once, if that is impossible. */
        fun open(path: File, isCompressed: Boolean, faults: Faults): LogFile? = try {
            val file = AppendFile(path)
            LogFile(path, if (isCompressed) GzipOutput(file) else PlainOutput(file))
        } catch (failure: IOException) {
            refused(path, failure, faults)
        } catch (failure: SecurityException) {
            refused(path, failure, faults)
        }

        private fun refused(path: File, failure: Exception, faults: Faults): LogFile? {
            faults.sayOnce("open") {
                "The log $path cannot be created: ${describe(failure)}. Nothing is logged; choose a folder that " +
                    "exists and can be written to, such as /home/lvuser/logs."
            }
            return null
        }
    }
}
