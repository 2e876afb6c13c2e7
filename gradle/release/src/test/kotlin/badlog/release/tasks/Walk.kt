package badlog.release.tasks

import java.io.File

/** Performs [task] in [project], a copy of badlog. It changes only the files that the task names, and fails if it needs another one. */
internal class Walk(private val project: File, private val task: GuidedTask) {
    private val used = HashSet<String>()

    /** The texts of the task's links that were not used so far. */
    val unused: Set<String> get() = task.files.keys - used

    /** Inserts [text] behind [place], which occurs once in the file called [name]. */
    fun insert(name: String, place: String, text: String) = replace(name, place, place + text)

    /** Replaces [old], which occurs once in the file called [name], with [new]. */
    fun replace(name: String, old: String, new: String) {
        val file = named(name)
        val parts = file.readText().split(old)
        check(parts.size == 2) { "$file should have one “$old”, not ${parts.size - 1}." }
        file.writeText(parts.joinToString(new))
    }

    /** Adds a file with [text] at [path], relative to the file or folder called [name]. */
    fun add(name: String, path: String, text: String) {
        val file = named(name).resolve(path).normalize()
        check(file.parentFile.parentFile.isDirectory) { "$file is not near a folder of the project." }
        file.parentFile.mkdirs()
        file.writeText(text)
    }

    /** Returns the file called [name]. */
    fun named(name: String): File {
        val path = checkNotNull(task.files[name]) { "“${task.title}” in CONTRIBUTING.md does not name $name, but needs it." }
        used += name
        return File(project, path).also { check(it.exists()) { "“${task.title}” in CONTRIBUTING.md names $path, which does not exist." } }
    }
}
