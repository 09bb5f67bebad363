// The names of the rock models, by their words in a project.

export const rockModels: Readonly<Record<string, string>> = {
  lumped_mass: 'lumped mass',
  rigid_sphere: 'rigid sphere',
  rigid_body: 'rigid body',
};

/// At the beginning of a title: "Lumped mass".
export function rockModelTitle(model: string): string {
  const name = rockModels[model] ?? model;
  return name.charAt(0).toUpperCase() + name.slice(1);
}
