package badlog.site

import java.nio.file.Path

/** Makes the site. Arguments: the project's folder, the site's folder, then the finished parts as `folder=path`. */
internal fun main(args: Array<String>) {
    val (root, target) = args
    val parts = args.drop(2).associate { it.substringBefore('=') to Path.of(it.substringAfter('=')) }
    Site(Path.of(root), parts).write(Path.of(target))
    println("The site is in $target/index.html")
}
