package badlog.rules.path

/**
 * A path that a robot drove, and the one that was planned for it.
 *
 * @property driven where the robot was.
 * @property planned where it was to be.
 */
public data class PlannedPath(public val driven: Pose, public val planned: Pose) {
    /** The names of the topics that tell how far apart they were. */
    public val topics: List<String> get() = listOf(driven.x, driven.y, planned.x, planned.y)

    public companion object {
        /**
         * The one of [poses]: those two that share the most folders, and of such the ones in the fewest; null without a plan. A plan that is
         * an array is where the robot will be, not where it is to be at a moment.
         */
        public fun of(poses: List<Pose>): PlannedPath? {
            val driven = poses.filter { it.role == PoseRole.DRIVEN }
            val planned = poses.filter { it.role == PoseRole.PLANNED && it.list == null }
            return planned.flatMap { plan -> driven.map { PlannedPath(it, plan) } }
                .minWithOrNull(compareBy({ -it.sharedFolders }, { it.driven.depth + it.planned.depth }))
        }
    }

    private val sharedFolders: Int
        get() = driven.name.split('/').dropLast(1).zip(planned.name.split('/').dropLast(1)).takeWhile { (one, other) -> one == other }.size
}
