package badlog.season.engine

import org.duckdb.DuckDBDriver

/** Thrown if DuckDB has no library for this system. The message includes advice. */
class NoEngineException(override val message: String) : Exception(message)

/**
 * Checks that DuckDB's jar has a library for this machine, because DuckDB's own message does not help.
 *
 * @param system the name of the system, as Java reports it.
 * @param machine the architecture of its processors, as Java reports it.
 * @throws NoEngineException if there is none.
 */
internal fun requireEngine(
    system: String = System.getProperty("os.name"),
    machine: String = System.getProperty("os.arch"),
    has: (String) -> Boolean = { DuckDBDriver::class.java.getResource("/$it") != null },
) {
    val isArm = machine == "aarch64" || machine == "arm64"
    val name = when {
        system.startsWith("Mac") -> "osx_universal"
        system.startsWith("Windows") -> if (isArm) "windows_arm64" else "windows_amd64"
        system.startsWith("Linux") -> if (isArm) "linux_arm64" else "linux_amd64"
        else -> return
    }
    if (has("libduckdb_java.so_$name")) return
    val advice = if (system.startsWith("Windows") && isArm) "use a Java for x64, which Windows on ARM can run" else "use another computer"
    throw NoEngineException("DuckDB, which makes and reads lakes, has no library for $system on $machine; $advice.")
}
