// workItem.glsl - chunk: the number of an invocation, however its work groups were laid out by
// nodes/drawable/gl/ComputeProgram.
int workItem()
{
  uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return int(group * gl_WorkGroupSize.x + gl_LocalInvocationIndex);
}
