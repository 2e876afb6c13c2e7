package badlog.core.recording

/**
 * Splits a name into its folder and its base name at the last `/`. `Drivetrain/Wheels/A Position` is `A Position` in the folder
 * `Drivetrain/Wheels`. A leading `/` does not make a folder.
 */
public object PathName {
    /** Returns the folder of [name], without slashes at its ends; empty for the root folder. */
    public fun folderOf(name: String): String {
        val slash = lastSeparator(name)
        return if (slash < 0) "" else name.substring(0, slash).trim('/')
    }

    /** Returns [name] without its folder; never empty unless [name] is. */
    public fun baseNameOf(name: String): String = name.substring(lastSeparator(name) + 1)

    // A slash at the very end separates nothing: "Arm/" would otherwise have no name at all.
    private fun lastSeparator(name: String): Int {
        for (i in name.length - 2 downTo 0) if (name[i] == '/') return i
        return -1
    }
}
